// SPDX-License-Identifier: MIT
#include "behavior/surface/WalkSurface.h"

#include <algorithm>
#include <cmath>

#include <recastnavigation/DetourNavMesh.h>
#include <recastnavigation/DetourNavMeshBuilder.h>
#include <recastnavigation/DetourNavMeshQuery.h>
#include <recastnavigation/Recast.h>

#include "model/base/Bounds.h"

namespace crowd::behavior {

namespace {

constexpr float kFinestCell = 0.2F;
constexpr double kMaxCells = 1.5e6;  ///< of the height field
constexpr float kAround = 15.0F;     ///< open ground about the stages, metres
constexpr float kFarthest = 2000.0F; ///< of places to reach, from the middle of the world
constexpr float kMostLevels = 8000.0F;
constexpr int kMaxCorners = 128;
constexpr int kMaxPolygons = 1024; ///< of a way
constexpr int kVerticesAPolygon = 6;
constexpr float kFindMetres[3] = {3.0F, 4.0F, 3.0F};
constexpr int kMaxNodes = 8192; ///< of a search
constexpr unsigned short kOpen = 1;
constexpr unsigned short kForbidden = 2;
constexpr unsigned char kPreferredArea = 1;
constexpr unsigned char kForbiddenArea = 2;
constexpr unsigned char kFirstSlowArea = 10;
constexpr int kSlowAreas = 20;      ///< so many steps of slowness
constexpr float kPreference = 2.0F; ///< a metre elsewhere counts like so many on liked ground
constexpr float kAreaBelow = 1.0F;  ///< metres under a place's height that belong to it
constexpr float kAreaHeight = 2.5F;

int slowStep(float speedShare)
{
    return std::clamp(static_cast<int>(std::lround(speedShare * kSlowAreas)), 1, kSlowAreas) - 1;
}

template<class T, void (*Free)(T*)>
struct Freed
{
    void operator()(T* object) const { Free(object); }
};
using HeightField = std::unique_ptr<rcHeightfield, Freed<rcHeightfield, rcFreeHeightField>>;
using Compact =
    std::unique_ptr<rcCompactHeightfield, Freed<rcCompactHeightfield, rcFreeCompactHeightfield>>;
using Contours = std::unique_ptr<rcContourSet, Freed<rcContourSet, rcFreeContourSet>>;
using Mesh = std::unique_ptr<rcPolyMesh, Freed<rcPolyMesh, rcFreePolyMesh>>;
using Detail = std::unique_ptr<rcPolyMeshDetail, Freed<rcPolyMeshDetail, rcFreePolyMeshDetail>>;
using NavMesh = std::unique_ptr<dtNavMesh, Freed<dtNavMesh, dtFreeNavMesh>>;
using Query = std::unique_ptr<dtNavMeshQuery, Freed<dtNavMeshQuery, dtFreeNavMeshQuery>>;

/// Triangles of stages and ground, as Recast wants them.
struct Soup
{
    std::vector<float> vertices;
    std::vector<int> triangles;
    model::Bounds bounds;

    void add(const glm::vec3& point)
    {
        vertices.insert(vertices.end(), {point.x, point.y, point.z});
    }
};

void addStage(const model::StageEntry& entry, Soup& soup)
{
    const glm::mat4 matrix = entry.worldFromStage();
    for (const model::StageMesh& mesh : entry.asset->meshes) {
        const auto first = static_cast<int>(soup.vertices.size() / 3);
        for (const glm::vec3& position : mesh.positions) {
            const glm::vec3 point = glm::vec3(matrix * glm::vec4(position, 1.0F));
            soup.add(point);
            soup.bounds.add(point);
        }
        for (const std::uint32_t index : mesh.indices) {
            soup.triangles.push_back(first + static_cast<int>(index));
        }
    }
}

/// The plane y = 0, in squares so that no triangle is far larger than the rest.
void addGround(Soup& soup)
{
    const glm::vec3 low = soup.bounds.low;
    const glm::vec3 high = soup.bounds.high;
    const auto first = static_cast<int>(soup.vertices.size() / 3);
    for (const glm::vec2& corner : {glm::vec2(low.x, low.z), glm::vec2(low.x, high.z),
                                    glm::vec2(high.x, high.z), glm::vec2(high.x, low.z)}) {
        soup.add({corner.x, 0.0F, corner.y});
    }
    for (const int index : {0, 1, 2, 0, 2, 3}) {
        soup.triangles.push_back(first + index);
    }
}

Soup soupOf(const SurfacePlan& plan)
{
    Soup soup;
    for (const model::StageEntry& entry : plan.stages) {
        if (entry.asset) {
            addStage(entry, soup);
        }
    }
    for (const glm::vec3& point : plan.points) {
        if (std::fabs(point.x) < kFarthest && std::fabs(point.z) < kFarthest) {
            soup.bounds.addPlace({point.x, std::clamp(point.y, -100.0F, 100.0F), point.z});
        }
    }
    if (!soup.bounds.isEmpty()) {
        soup.bounds.low -= glm::vec3(kAround, 0.5F, kAround);
        soup.bounds.high += glm::vec3(kAround, 2.5F, kAround);
        soup.bounds.low.y = std::min(soup.bounds.low.y, -0.5F);
        soup.bounds.high.y = std::max(soup.bounds.high.y, 2.5F);
        addGround(soup);
    }
    return soup;
}

rcConfig configFor(const Soup& soup, const SurfaceSettings& settings)
{
    rcConfig config{};
    const glm::vec3 size = soup.bounds.high - soup.bounds.low;
    const double area = static_cast<double>(size.x) * static_cast<double>(size.z);
    config.cs = std::max(kFinestCell, static_cast<float>(std::sqrt(area / kMaxCells)));
    config.ch = std::max({0.05F, config.cs * 0.2F, size.y / kMostLevels});
    config.walkableSlopeAngle = settings.slopeDegrees;
    config.walkableHeight = static_cast<int>(std::ceil(settings.height / config.ch));
    config.walkableClimb = static_cast<int>(std::floor(settings.climb / config.ch));
    config.walkableRadius = static_cast<int>(std::ceil(settings.radius / config.cs));
    config.maxEdgeLen = static_cast<int>(12.0F / config.cs);
    config.maxSimplificationError = 1.1F;
    config.minRegionArea = static_cast<int>(1.0F / (config.cs * config.cs));
    config.mergeRegionArea = static_cast<int>(9.0F / (config.cs * config.cs));
    config.maxVertsPerPoly = kVerticesAPolygon;
    config.detailSampleDist = 1.5F;
    config.detailSampleMaxError = 0.06F;
    for (int axis = 0; axis < 3; ++axis) {
        config.bmin[axis] = soup.bounds.low[axis];
        config.bmax[axis] = soup.bounds.high[axis];
    }
    rcCalcGridSize(config.bmin, config.bmax, config.cs, &config.width, &config.height);
    return config;
}

} // namespace

struct WalkSurface::Private
{
    NavMesh mesh;
    std::vector<Wall> walls;
    std::size_t polygons = 0;
    float cellHeight = 0.0F;
    dtQueryFilter filter;     ///< for ways
    dtQueryFilter everything; ///< also where nobody is to walk

    /// One for each thread that asks.
    [[nodiscard]] dtNavMeshQuery* query() const
    {
        thread_local Query cached;
        thread_local const dtNavMesh* cachedFor = nullptr;
        if (cachedFor != mesh.get() || !cached) {
            cached.reset(dtAllocNavMeshQuery());
            cachedFor = cached && dtStatusSucceed(cached->init(mesh.get(), kMaxNodes)) ? mesh.get()
                                                                                       : nullptr;
        }
        return cachedFor == nullptr ? nullptr : cached.get();
    }
};

namespace {

/// Steps of the building, each of which may fail.
class Builder
{
public:
    Builder(const Soup& soup, const SurfacePlan& plan, WalkSurface::Progress& progress)
        : m_soup(soup), m_areas(plan.areas), m_config(configFor(soup, plan.settings)),
          m_progress(progress)
    {
    }

    bool run(const SurfaceSettings& settings)
    {
        return rasterize() && next(0.4F) && filter() && next(0.7F) && outline() && next(0.85F) &&
               assemble(settings);
    }
    [[nodiscard]] NavMesh take() { return std::move(m_nav); }
    [[nodiscard]] const rcPolyMesh& mesh() const { return *m_mesh; }

private:
    bool next(float done)
    {
        m_progress.done = done;
        return !m_progress.isCancelled;
    }

    bool rasterize()
    {
        m_field.reset(rcAllocHeightfield());
        if (!m_field ||
            !rcCreateHeightfield(&m_context, *m_field, m_config.width, m_config.height,
                                 m_config.bmin, m_config.bmax, m_config.cs, m_config.ch)) {
            return false;
        }
        const auto vertices = static_cast<int>(m_soup.vertices.size() / 3);
        const std::size_t count = m_soup.triangles.size() / 3;
        constexpr std::size_t kBatch = 4096;
        for (std::size_t first = 0; first < count; first += kBatch) {
            const auto batch = static_cast<int>(std::min(kBatch, count - first));
            std::vector<unsigned char> areas(static_cast<std::size_t>(batch), 0);
            const int* triangles = &m_soup.triangles[first * 3];
            rcMarkWalkableTriangles(&m_context, m_config.walkableSlopeAngle, m_soup.vertices.data(),
                                    vertices, triangles, batch, areas.data());
            if (!rcRasterizeTriangles(&m_context, m_soup.vertices.data(), vertices, triangles,
                                      areas.data(), batch, *m_field, m_config.walkableClimb) ||
                !next(0.4F * static_cast<float>(first) / static_cast<float>(count))) {
                return false;
            }
        }
        return true;
    }

    bool filter()
    {
        rcFilterLowHangingWalkableObstacles(&m_context, m_config.walkableClimb, *m_field);
        rcFilterLedgeSpans(&m_context, m_config.walkableHeight, m_config.walkableClimb, *m_field);
        rcFilterWalkableLowHeightSpans(&m_context, m_config.walkableHeight, *m_field);
        m_compact.reset(rcAllocCompactHeightfield());
        return m_compact &&
               rcBuildCompactHeightfield(&m_context, m_config.walkableHeight,
                                         m_config.walkableClimb, *m_field, *m_compact) &&
               rcErodeWalkableArea(&m_context, m_config.walkableRadius, *m_compact) &&
               markAreas() && rcBuildDistanceField(&m_context, *m_compact) &&
               rcBuildRegions(&m_context, *m_compact, 0, m_config.minRegionArea,
                              m_config.mergeRegionArea);
    }

    void mark(const model::Place& place, float margin, unsigned char area)
    {
        const float foot[3] = {place.position.x, place.position.y - kAreaBelow, place.position.z};
        rcMarkCylinderArea(&m_context, foot, place.radius + margin, kAreaHeight, area, *m_compact);
    }

    /// Liked ground first, what nobody may walk on last: where they meet, the stricter one counts.
    bool markAreas()
    {
        const float body = static_cast<float>(m_config.walkableRadius) * m_config.cs;
        for (const model::Place& place : m_areas) {
            if (place.role == model::PlaceRole::Preferred) {
                mark(place, 0.0F, kPreferredArea);
            }
        }
        for (const model::Place& place : m_areas) {
            if (place.role == model::PlaceRole::Slow) {
                mark(place, 0.0F,
                     static_cast<unsigned char>(kFirstSlowArea + slowStep(place.speedShare)));
            }
        }
        for (const model::Place& place : m_areas) {
            if (place.role == model::PlaceRole::Forbidden) {
                mark(place, body, kForbiddenArea);
            } else if (place.role == model::PlaceRole::Obstacle) {
                mark(place, body, RC_NULL_AREA);
            }
        }
        return true;
    }

    bool outline()
    {
        m_field.reset();
        const Contours contours(rcAllocContourSet());
        m_mesh.reset(rcAllocPolyMesh());
        m_detail.reset(rcAllocPolyMeshDetail());
        return contours && m_mesh && m_detail &&
               rcBuildContours(&m_context, *m_compact, m_config.maxSimplificationError,
                               m_config.maxEdgeLen, *contours) &&
               rcBuildPolyMesh(&m_context, *contours, kVerticesAPolygon, *m_mesh) &&
               rcBuildPolyMeshDetail(&m_context, *m_mesh, *m_compact, m_config.detailSampleDist,
                                     m_config.detailSampleMaxError, *m_detail);
    }

    bool assemble(const SurfaceSettings& settings)
    {
        for (int i = 0; i < m_mesh->npolys; ++i) {
            m_mesh->flags[i] = m_mesh->areas[i] == RC_NULL_AREA     ? 0
                               : m_mesh->areas[i] == kForbiddenArea ? kForbidden
                                                                    : kOpen;
        }
        dtNavMeshCreateParams params{};
        params.verts = m_mesh->verts;
        params.vertCount = m_mesh->nverts;
        params.polys = m_mesh->polys;
        params.polyAreas = m_mesh->areas;
        params.polyFlags = m_mesh->flags;
        params.polyCount = m_mesh->npolys;
        params.nvp = m_mesh->nvp;
        params.detailMeshes = m_detail->meshes;
        params.detailVerts = m_detail->verts;
        params.detailVertsCount = m_detail->nverts;
        params.detailTris = m_detail->tris;
        params.detailTriCount = m_detail->ntris;
        params.walkableHeight = settings.height;
        params.walkableRadius = settings.radius;
        params.walkableClimb = settings.climb;
        rcVcopy(params.bmin, m_mesh->bmin);
        rcVcopy(params.bmax, m_mesh->bmax);
        params.cs = m_config.cs;
        params.ch = m_config.ch;
        params.buildBvTree = true;
        unsigned char* data = nullptr;
        int size = 0;
        if (!dtCreateNavMeshData(&params, &data, &size)) {
            return false;
        }
        m_nav.reset(dtAllocNavMesh());
        if (!m_nav || dtStatusFailed(m_nav->init(data, size, DT_TILE_FREE_DATA))) {
            dtFree(data);
            return false;
        }
        return true;
    }

    const Soup& m_soup;
    std::span<const model::Place> m_areas;
    rcConfig m_config;
    WalkSurface::Progress& m_progress;
    rcContext m_context{false};
    HeightField m_field;
    Compact m_compact;
    Mesh m_mesh;
    Detail m_detail;
    NavMesh m_nav;
};

/// Edges of the polygons beyond which there is nothing.
std::vector<Wall> wallsOf(const rcPolyMesh& mesh, const SurfaceSettings& settings)
{
    std::vector<Wall> walls;
    const auto point = [&mesh](unsigned short vertex) {
        const unsigned short* v = &mesh.verts[vertex * 3];
        return glm::vec3(mesh.bmin[0] + static_cast<float>(v[0]) * mesh.cs,
                         mesh.bmin[1] + static_cast<float>(v[1]) * mesh.ch,
                         mesh.bmin[2] + static_cast<float>(v[2]) * mesh.cs);
    };
    for (int p = 0; p < mesh.npolys; ++p) {
        const unsigned short* polygon = &mesh.polys[p * 2 * mesh.nvp];
        for (int e = 0; e < mesh.nvp && polygon[e] != RC_MESH_NULL_IDX; ++e) {
            if (polygon[mesh.nvp + e] != RC_MESH_NULL_IDX) {
                continue;
            }
            const bool isLast = e + 1 >= mesh.nvp || polygon[e + 1] == RC_MESH_NULL_IDX;
            const glm::vec3 a = point(polygon[e]);
            const glm::vec3 b = point(polygon[isLast ? 0 : e + 1]);
            const auto isOutside = [&](const glm::vec3& corner) {
                const float margin = settings.radius + 4.0F * mesh.cs;
                return corner.x < mesh.bmin[0] + margin || corner.x > mesh.bmax[0] - margin ||
                       corner.z < mesh.bmin[2] + margin || corner.z > mesh.bmax[2] - margin;
            };
            if (isOutside(a) && isOutside(b)) {
                continue; // the open ground goes on
            }
            // The surface ends a body's radius before what stands there.
            const glm::vec2 along(b.x - a.x, b.z - a.z);
            const float length = std::sqrt(along.x * along.x + along.y * along.y);
            if (length < 1e-4F) {
                continue;
            }
            const glm::vec2 out = glm::vec2(along.y, -along.x) / length * settings.radius;
            walls.push_back({glm::vec2(a.x, a.z) - out, glm::vec2(b.x, b.z) - out,
                             std::min(a.y, b.y) - 1.0F, std::max(a.y, b.y) + 1.0F});
        }
    }
    return walls;
}

} // namespace

WalkSurface::WalkSurface(std::unique_ptr<Private> data) : m_private(std::move(data)) {}
WalkSurface::~WalkSurface() = default;

SurfacePlan SurfacePlan::of(const model::Scene& scene)
{
    SurfacePlan plan{scene.stages, {}, scene.surface, {}};
    const auto positions = scene.population.column(model::columns::position);
    plan.points.assign(positions.begin(), positions.end());
    for (const model::Place& place : scene.places) {
        plan.points.push_back(place.position);
        const bool isArea =
            model::changesWays(place.role) || place.role == model::PlaceRole::Obstacle;
        if (isArea && model::Bounds::isPlace(place.position) && std::isfinite(place.radius)) {
            plan.areas.push_back(place);
        }
    }
    return plan;
}

bool SurfacePlan::isWorthwhile() const
{
    return !areas.empty() ||
           std::ranges::any_of(stages, [](const auto& stage) { return stage.asset != nullptr; });
}

bool SurfacePlan::hasSameWays(const SurfacePlan& other) const
{
    return settings == other.settings &&
           std::ranges::equal(areas, other.areas, [](const auto& a, const auto& b) {
               return a.role == b.role && a.position == b.position && a.radius == b.radius &&
                      a.speedShare == b.speedShare;
           });
}

model::Result<std::shared_ptr<const WalkSurface>> WalkSurface::build(const SurfacePlan& plan,
                                                                     Progress& progress)
{
    const Soup soup = plan.isWorthwhile() ? soupOf(plan) : Soup();
    if (soup.triangles.empty()) {
        return model::Error{"There is no stage to walk on; people walk on open ground."};
    }
    Builder builder(soup, plan, progress);
    if (!builder.run(plan.settings)) {
        return model::Error{progress.isCancelled
                                ? "The walkable surface was not built: it was cancelled."
                                : "Nothing of the stage can be walked on; people walk on open "
                                  "ground. Check its size, which way is up, and how wide, tall and "
                                  "steep people can walk (Environment panel)."};
    }
    auto data = std::make_unique<Private>();
    data->walls = wallsOf(builder.mesh(), plan.settings);
    data->polygons = static_cast<std::size_t>(builder.mesh().npolys);
    data->cellHeight = builder.mesh().ch;
    data->mesh = builder.take();
    data->filter.setIncludeFlags(kOpen);
    data->everything.setIncludeFlags(kOpen | kForbidden);
    // The search wants no metre to cost less than 1: liked ground does, the rest more.
    const bool hasLiked = std::ranges::any_of(plan.areas, [](const model::Place& place) {
        return place.role == model::PlaceRole::Preferred;
    });
    const float usual = hasLiked ? kPreference : 1.0F;
    data->filter.setAreaCost(RC_WALKABLE_AREA, usual);
    data->filter.setAreaCost(kPreferredArea, 1.0F);
    for (int step = 0; step < kSlowAreas; ++step) {
        data->filter.setAreaCost(kFirstSlowArea + step, usual * static_cast<float>(kSlowAreas) /
                                                            static_cast<float>(step + 1));
    }
    progress.done = 1.0F;
    return std::shared_ptr<const WalkSurface>(new WalkSurface(std::move(data)));
}

std::vector<glm::vec2> WalkSurface::way(const glm::vec3& from, const glm::vec3& to) const
{
    const dtNavMeshQuery* query = m_private->query();
    if (query == nullptr) {
        return {};
    }
    const dtQueryFilter& filter = m_private->filter;
    dtPolyRef start = 0;
    dtPolyRef end = 0;
    float startPoint[3];
    float endPoint[3];
    query->findNearestPoly(&from.x, kFindMetres, &filter, &start, startPoint);
    query->findNearestPoly(&to.x, kFindMetres, &filter, &end, endPoint);
    if (start == 0 || end == 0) {
        return {};
    }
    dtPolyRef polygons[kMaxPolygons];
    int count = 0;
    query->findPath(start, end, startPoint, endPoint, &filter, polygons, &count, kMaxPolygons);
    if (count == 0) {
        return {};
    }
    const bool isWhole = polygons[count - 1] == end;
    if (!isWhole) {
        query->closestPointOnPoly(polygons[count - 1], endPoint, endPoint, nullptr);
    }
    float corners[kMaxCorners * 3];
    int cornerCount = 0;
    query->findStraightPath(startPoint, endPoint, polygons, count, corners, nullptr, nullptr,
                            &cornerCount, kMaxCorners);
    std::vector<glm::vec2> way;
    for (int i = 1; i < cornerCount; ++i) {
        way.emplace_back(corners[i * 3], corners[i * 3 + 2]);
    }
    // What lies on the surface is reached exactly.
    const glm::vec2 aimed(to.x, to.z);
    if (isWhole && !way.empty() && glm::distance(way.back(), aimed) < 0.05F) {
        way.back() = aimed;
    }
    return way;
}

float WalkSurface::height(float x, float z, float near) const
{
    const dtNavMeshQuery* query = m_private->query();
    if (query == nullptr) {
        return near;
    }
    const float point[3] = {x, near, z};
    const float reach[3] = {0.3F, 2.0F, 0.3F};
    dtPolyRef polygon = 0;
    float nearest[3];
    query->findNearestPoly(point, reach, &m_private->everything, &polygon, nearest);
    float found = near;
    if (polygon != 0 && dtStatusFailed(query->getPolyHeight(polygon, nearest, &found))) {
        found = nearest[1];
    }
    // Recast lays its surface a cell's height above what it was made from.
    return polygon != 0 ? found - m_private->cellHeight : near;
}

bool WalkSurface::reaches(const glm::vec3& point, float metres) const
{
    const dtNavMeshQuery* query = m_private->query();
    const float reach[3] = {metres, 2.0F, metres};
    dtPolyRef polygon = 0;
    float nearest[3];
    return query != nullptr &&
           dtStatusSucceed(
               query->findNearestPoly(&point.x, reach, &m_private->filter, &polygon, nearest)) &&
           polygon != 0;
}

std::span<const Wall> WalkSurface::walls() const
{
    return m_private->walls;
}

std::size_t WalkSurface::polygons() const
{
    return m_private->polygons;
}

} // namespace crowd::behavior
