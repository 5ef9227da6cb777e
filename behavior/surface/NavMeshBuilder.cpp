// SPDX-License-Identifier: MIT
#include "behavior/surface/NavMeshBuilder.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <recastnavigation/DetourNavMeshBuilder.h>

#include "behavior/surface/SurfaceAreas.h"

namespace crowd::behavior {

namespace {

constexpr float kFinestCell = 0.2F;
constexpr double kMaxCells = 1.5e6; ///< of the height field
constexpr float kMostCellsASide = 30000.0F;
constexpr float kMostLevels = 8000.0F;
constexpr float kWidestArea = 1e6F;
constexpr int kVerticesAPolygon = 6;
constexpr float kAreaBelow = 1.0F; ///< metres under a place's height that belong to it
constexpr float kAreaHeight = 2.5F;

using Contours = std::unique_ptr<rcContourSet, Freed<rcContourSet, rcFreeContourSet>>;

int slowStep(float speedShare)
{
    return std::clamp(static_cast<int>(std::lround(speedShare * kSlowAreas)), 1, kSlowAreas) - 1;
}

rcConfig configFor(const TriangleSoup& soup, const SurfaceSettings& settings)
{
    rcConfig config{};
    const glm::vec3 size = soup.bounds.high - soup.bounds.low;
    const double area = static_cast<double>(size.x) * static_cast<double>(size.z);
    config.cs = std::max({kFinestCell, static_cast<float>(std::sqrt(area / kMaxCells)),
                          std::max(size.x, size.z) / kMostCellsASide});
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
    // In metres, both: on ground from pole to pole samples as close as on a square would never end.
    config.detailSampleDist = std::max(1.5F, 3.0F * config.cs);
    config.detailSampleMaxError = std::max(0.06F, 0.6F * config.ch);
    for (int axis = 0; axis < 3; ++axis) {
        config.bmin[axis] = soup.bounds.low[axis];
        config.bmax[axis] = soup.bounds.high[axis];
    }
    rcCalcGridSize(config.bmin, config.bmax, config.cs, &config.width, &config.height);
    config.width = std::max(config.width, 1);
    config.height = std::max(config.height, 1);
    return config;
}

} // namespace

NavMeshBuilder::NavMeshBuilder(const TriangleSoup& soup, const SurfacePlan& plan,
                               WalkSurface::Progress& progress)
    : m_soup(soup), m_areas(plan.areas), m_config(configFor(soup, plan.settings)),
      m_progress(progress)
{
}

bool NavMeshBuilder::run(const SurfaceSettings& settings)
{
    return rasterize() && next(0.4F) && filter() && next(0.7F) && outline() && next(0.85F) &&
           assemble(settings);
}

bool NavMeshBuilder::next(float done)
{
    m_progress.done = done;
    return !m_progress.isOver();
}

bool NavMeshBuilder::rasterize()
{
    m_field.reset(rcAllocHeightfield());
    if (!m_field || !rcCreateHeightfield(&m_context, *m_field, m_config.width, m_config.height,
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

bool NavMeshBuilder::filter()
{
    rcFilterLowHangingWalkableObstacles(&m_context, m_config.walkableClimb, *m_field);
    if (!next(0.42F)) {
        return false;
    }
    rcFilterLedgeSpans(&m_context, m_config.walkableHeight, m_config.walkableClimb, *m_field);
    rcFilterWalkableLowHeightSpans(&m_context, m_config.walkableHeight, *m_field);
    m_compact.reset(rcAllocCompactHeightfield());
    return next(0.46F) && m_compact &&
           rcBuildCompactHeightfield(&m_context, m_config.walkableHeight, m_config.walkableClimb,
                                     *m_field, *m_compact) &&
           next(0.5F) && rcErodeWalkableArea(&m_context, m_config.walkableRadius, *m_compact) &&
           next(0.55F) && markAreas() && rcBuildDistanceField(&m_context, *m_compact) &&
           next(0.6F) &&
           rcBuildRegions(&m_context, *m_compact, 0, m_config.minRegionArea,
                          m_config.mergeRegionArea);
}

void NavMeshBuilder::mark(const model::Place& place, float margin, unsigned char area)
{
    const float radius = std::min(place.radius, kWidestArea) + margin;
    // It counts cells from the corner, as whole numbers: none that is far off may come to it.
    for (const int axis : {0, 2}) {
        if (!(place.position[axis] + radius > m_config.bmin[axis] &&
              place.position[axis] - radius < m_config.bmax[axis])) {
            return;
        }
    }
    const float y = std::clamp(place.position.y - kAreaBelow, m_config.bmin[1] - kAreaHeight,
                               m_config.bmax[1] + kAreaHeight);
    const float foot[3] = {place.position.x, y, place.position.z};
    rcMarkCylinderArea(&m_context, foot, radius, kAreaHeight, area, *m_compact);
}

/// Liked ground first, what nobody may walk on last: where they meet, the stricter one counts.
bool NavMeshBuilder::markAreas()
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

bool NavMeshBuilder::outline()
{
    m_field.reset();
    const Contours contours(rcAllocContourSet());
    m_mesh.reset(rcAllocPolyMesh());
    m_detail.reset(rcAllocPolyMeshDetail());
    return contours && m_mesh && m_detail &&
           rcBuildContours(&m_context, *m_compact, m_config.maxSimplificationError,
                           m_config.maxEdgeLen, *contours) &&
           next(0.75F) && rcBuildPolyMesh(&m_context, *contours, kVerticesAPolygon, *m_mesh) &&
           next(0.8F) &&
           rcBuildPolyMeshDetail(&m_context, *m_mesh, *m_compact, m_config.detailSampleDist,
                                 m_config.detailSampleMaxError, *m_detail);
}

bool NavMeshBuilder::assemble(const SurfaceSettings& settings)
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

} // namespace crowd::behavior
