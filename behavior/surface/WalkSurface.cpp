// SPDX-License-Identifier: MIT
#include "behavior/surface/WalkSurface.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <recastnavigation/DetourNavMeshQuery.h>

#include "behavior/surface/NavMeshBuilder.h"
#include "behavior/surface/SurfaceAreas.h"
#include "behavior/surface/SurfaceWalls.h"

namespace crowd::behavior {

namespace {

constexpr int kMaxCorners = 128;
constexpr int kMaxPolygons = 1024; ///< of a way
constexpr float kFindMetres[3] = {3.0F, 4.0F, 3.0F};
constexpr int kMaxNodes = 8192;     ///< of a search
constexpr float kPreference = 2.0F; ///< a metre elsewhere counts like so many on liked ground

using Query = std::unique_ptr<dtNavMeshQuery, Freed<dtNavMeshQuery, dtFreeNavMeshQuery>>;

void setCosts(const SurfacePlan& plan, dtQueryFilter& filter)
{
    // The search wants no metre to cost less than 1: liked ground does, the rest more.
    const bool hasLiked = std::ranges::any_of(plan.areas, [](const model::Place& place) {
        return place.role == model::PlaceRole::Preferred;
    });
    const float usual = hasLiked ? kPreference : 1.0F;
    filter.setAreaCost(RC_WALKABLE_AREA, usual);
    filter.setAreaCost(kPreferredArea, 1.0F);
    for (int step = 0; step < kSlowAreas; ++step) {
        filter.setAreaCost(kFirstSlowArea + step,
                           usual * static_cast<float>(kSlowAreas) / static_cast<float>(step + 1));
    }
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

WalkSurface::WalkSurface(std::unique_ptr<Private> data) : m_private(std::move(data)) {}
WalkSurface::~WalkSurface() = default;

model::Result<std::shared_ptr<const WalkSurface>> WalkSurface::build(const SurfacePlan& plan,
                                                                     Progress& progress)
{
    const TriangleSoup soup = plan.isWorthwhile() ? soupOf(plan) : TriangleSoup();
    if (soup.triangles.empty()) {
        return model::Error{"There is no stage to walk on; people walk on open ground."};
    }
    NavMeshBuilder builder(soup, plan, progress);
    if (!builder.run(plan.settings)) {
        return model::Error{progress.isOver()
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
    setCosts(plan, data->filter);
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

std::optional<glm::vec3> WalkSurface::straight(const glm::vec3& from, const glm::vec3& to) const
{
    constexpr float kReach[3] = {0.3F, 2.0F, 0.3F};
    constexpr float kWithinEdge = 0.98F; // of the way to it
    const dtNavMeshQuery* query = m_private->query();
    const dtQueryFilter& filter = m_private->filter;
    dtPolyRef start = 0;
    float at[3];
    if (query == nullptr ||
        dtStatusFailed(query->findNearestPoly(&from.x, kReach, &filter, &start, at)) ||
        start == 0) {
        return std::nullopt;
    }
    const float end[3] = {to.x, at[1], to.z};
    float share = 1.0F;
    float normal[3];
    dtPolyRef polygons[kMaxPolygons];
    int count = 0;
    query->raycast(start, at, end, &filter, &share, normal, polygons, &count, kMaxPolygons);
    share = share > 1.0F ? 1.0F : share * kWithinEdge;
    const float point[3] = {at[0] + (end[0] - at[0]) * share, at[1],
                            at[2] + (end[2] - at[2]) * share};
    float found = at[1];
    if (count > 0) {
        (void)query->getPolyHeight(polygons[count - 1], point, &found);
    }
    return glm::vec3(point[0], found - m_private->cellHeight, point[2]);
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
