// SPDX-License-Identifier: MIT
#include "behavior/surface/TileBuilder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <recastnavigation/DetourNavMeshBuilder.h>

#include "behavior/surface/SurfaceAreas.h"
#include "model/base/Bounds.h"
#include "model/scene/PlaceShape.h"

namespace crowd::behavior {

namespace {

constexpr float kSlimmest = 0.5F; ///< of a body's radius, where a way is narrow
constexpr float kWidestArea = 1e6F;
constexpr int kVerticesAPolygon = 6;
constexpr float kAreaBelow = 1.0F; ///< metres under a place's height that belong to it
constexpr float kAreaHeight = 2.5F;
constexpr float kEdgeMetres = 0.2F; ///< by which edges may be straighter than what stands there
constexpr int kBorderCells = 8;     ///< about a tile, beside a body's: what its edges are told from
constexpr float kNearlyWhole = 0.01F; ///< of a cell's height, so that 9 of 0.05 m are 0.45 m

using Contours = std::unique_ptr<rcContourSet, Freed<rcContourSet, rcFreeContourSet>>;

int slowStep(float speedShare)
{
    return std::clamp(static_cast<int>(std::lround(speedShare * kSlowAreas)), 1, kSlowAreas) - 1;
}

rcConfig configFor(const TriangleSoup& soup, const SurfaceSettings& settings,
                   const SurfaceTiles& tiles, std::size_t tile)
{
    rcConfig config{};
    config.cs = tiles.cells[tile];
    config.ch = tiles.cellHeight;
    config.walkableSlopeAngle = settings.slopeDegrees;
    config.walkableHeight = static_cast<int>(std::ceil(settings.height / config.ch));
    config.walkableClimb = static_cast<int>(std::floor(settings.climb / config.ch + kNearlyWhole));
    // What is met fills its cells, half a cell more than it is wide: that is not added once more.
    config.walkableRadius = static_cast<int>(std::lround(settings.radius / config.cs));
    config.borderSize = config.walkableRadius + kBorderCells;
    config.maxEdgeLen = static_cast<int>(12.0F / config.cs);
    config.maxSimplificationError = std::max(1.1F, kEdgeMetres / config.cs);
    config.minRegionArea = static_cast<int>(1.0F / (config.cs * config.cs));
    config.mergeRegionArea = static_cast<int>(9.0F / (config.cs * config.cs));
    config.maxVertsPerPoly = kVerticesAPolygon;
    config.tileSize = static_cast<int>(std::lround(tiles.side / config.cs));
    config.width = config.height = config.tileSize + 2 * config.borderSize;
    // In metres, both: on ground from pole to pole samples as close as on a square would never end.
    config.detailSampleDist = std::max(1.5F, 3.0F * config.cs);
    config.detailSampleMaxError = std::max(0.06F, 0.6F * config.ch);
    const float border = static_cast<float>(config.borderSize) * config.cs;
    const glm::vec2 low = tiles.low(tile);
    for (const int axis : {0, 1}) {
        config.bmin[2 * axis] = low[axis] - border;
        config.bmax[2 * axis] = low[axis] + tiles.side + border;
    }
    config.bmin[1] = soup.bounds.low.y;
    config.bmax[1] = soup.bounds.high.y;
    return config;
}

} // namespace

TileBuilder::TileBuilder(const TriangleSoup& soup, const SurfacePlan& plan,
                         const SurfaceTiles& tiles, std::size_t tile,
                         const WalkSurface::Progress& progress)
    : m_soup(soup), m_plan(plan), m_tiles(tiles), m_tile(tile),
      m_config(configFor(soup, plan.settings, tiles, tile)),
      m_body{m_config.walkableRadius,
             static_cast<int>(std::floor(kSlimmest * plan.settings.radius / m_config.cs))},
      m_progress(progress)
{
}

bool TileBuilder::run(TileData& into)
{
    return rasterize() && goesOn() && filter() && goesOn() && outline() && goesOn() &&
           assemble(into);
}

bool TileBuilder::rasterize()
{
    m_field.reset(rcAllocHeightfield());
    if (!m_field || !rcCreateHeightfield(&m_context, *m_field, m_config.width, m_config.height,
                                         m_config.bmin, m_config.bmax, m_config.cs, m_config.ch)) {
        return false;
    }
    const auto vertices = static_cast<int>(m_soup.vertices.size() / 3);
    const std::vector<std::size_t>& indices = m_tiles.triangles[m_tile];
    constexpr std::size_t kBatch = 4096;
    std::vector<int> triangles;
    for (std::size_t first = 0; first < indices.size(); first += kBatch) {
        const std::size_t count = std::min(kBatch, indices.size() - first);
        triangles.clear();
        for (std::size_t i = first; i < first + count; ++i) {
            const int* corners = &m_soup.triangles[indices[i] * 3];
            triangles.insert(triangles.end(), corners, corners + 3);
        }
        std::vector<unsigned char> areas(count, 0);
        const auto batch = static_cast<int>(count);
        rcMarkWalkableTriangles(&m_context, m_config.walkableSlopeAngle, m_soup.vertices.data(),
                                vertices, triangles.data(), batch, areas.data());
        if (!rcRasterizeTriangles(&m_context, m_soup.vertices.data(), vertices, triangles.data(),
                                  areas.data(), batch, *m_field, m_config.walkableClimb) ||
            !goesOn()) {
            return false;
        }
    }
    return true;
}

bool TileBuilder::filter()
{
    rcFilterLowHangingWalkableObstacles(&m_context, m_config.walkableClimb, *m_field);
    rcFilterLedgeSpans(&m_context, m_config.walkableHeight, m_config.walkableClimb, *m_field);
    rcFilterWalkableLowHeightSpans(&m_context, m_config.walkableHeight, *m_field);
    m_compact.reset(rcAllocCompactHeightfield());
    if (!m_compact ||
        !rcBuildCompactHeightfield(&m_context, m_config.walkableHeight, m_config.walkableClimb,
                                   *m_field, *m_compact) ||
        !goesOn() || !erodeForBodies(m_context, m_body, *m_compact)) {
        return false;
    }
    m_field.reset();
    markAreas();
    return goesOn() && rcBuildDistanceField(&m_context, *m_compact) && goesOn() &&
           rcBuildRegions(&m_context, *m_compact, m_config.borderSize, m_config.minRegionArea,
                          m_config.mergeRegionArea);
}

/// What a place takes up, and so much around it.
void TileBuilder::mark(const model::Place& place, float margin, unsigned char area)
{
    if (place.shape == model::PlaceShape::Round) {
        markDisc(place, margin, area);
        return;
    }
    const std::vector<glm::vec3> corners = model::cornersOf(place);
    const bool isArea = place.shape == model::PlaceShape::Area;
    if (isArea) {
        markEnclosed(corners, area);
    }
    model::Place knob = place;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        knob.position = corners[i];
        markDisc(knob, margin, area);
        if (isArea || i + 1 < corners.size()) {
            markStrip(corners[i], corners[(i + 1) % corners.size()], place.radius + margin, area);
        }
    }
}

/// A rectangle over the way from one corner to the next.
void TileBuilder::markStrip(const glm::vec3& from, const glm::vec3& to, float half,
                            unsigned char area)
{
    const glm::vec3 way = (to - from) * glm::vec3(1.0F, 0.0F, 1.0F);
    const float metres = glm::length(way);
    if (metres > 0.0F) {
        const glm::vec3 aside = glm::vec3(way.z, 0.0F, -way.x) * (half / metres);
        const std::array corners{from - aside, to - aside, to + aside, from + aside};
        markEnclosed(corners, area);
    }
}

/// Whatever lies within an odd number of sides, which is how Recast asks.
void TileBuilder::markEnclosed(std::span<const glm::vec3> corners, unsigned char area)
{
    model::Bounds bounds;
    std::vector<float> coordinates;
    coordinates.reserve(corners.size() * 3);
    for (const glm::vec3& corner : corners) {
        bounds.add(corner);
        coordinates.insert(coordinates.end(), {corner.x, corner.y, corner.z});
    }
    for (const int axis : {0, 2}) {
        if (!(bounds.high[axis] > m_config.bmin[axis] && bounds.low[axis] < m_config.bmax[axis])) {
            return;
        }
    }
    const auto within = [this](float y) {
        return std::clamp(y, m_config.bmin[1] - kAreaHeight, m_config.bmax[1] + kAreaHeight);
    };
    rcMarkConvexPolyArea(&m_context, coordinates.data(), static_cast<int>(corners.size()),
                         within(bounds.low.y - kAreaBelow),
                         within(bounds.high.y + kAreaHeight - kAreaBelow), area, *m_compact);
}

void TileBuilder::markDisc(const model::Place& place, float margin, unsigned char area)
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
void TileBuilder::markAreas()
{
    const float body = m_plan.settings.radius;
    for (const model::Place& place : m_plan.areas) {
        if (place.role == model::PlaceRole::Preferred) {
            mark(place, 0.0F, kPreferredArea);
        }
    }
    for (const model::Place& place : m_plan.areas) {
        if (place.role == model::PlaceRole::Slow) {
            mark(place, 0.0F,
                 static_cast<unsigned char>(kFirstSlowArea + slowStep(place.speedShare)));
        }
    }
    for (const model::Place& place : m_plan.areas) {
        if (place.role == model::PlaceRole::Forbidden) {
            mark(place, body, kForbiddenArea);
        } else if (place.role == model::PlaceRole::Obstacle) {
            mark(place, body, RC_NULL_AREA);
        }
    }
}

bool TileBuilder::outline()
{
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

bool TileBuilder::assemble(TileData& into)
{
    if (m_mesh->npolys == 0) {
        return true;
    }
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
    params.walkableHeight = m_plan.settings.height;
    params.walkableRadius = m_plan.settings.radius;
    params.walkableClimb = m_plan.settings.climb;
    params.tileX = static_cast<int>(m_tile) % m_tiles.columns;
    params.tileY = static_cast<int>(m_tile) / m_tiles.columns;
    rcVcopy(params.bmin, m_mesh->bmin);
    rcVcopy(params.bmax, m_mesh->bmax);
    params.cs = m_config.cs;
    params.ch = m_config.ch;
    params.buildBvTree = true;
    unsigned char* data = nullptr;
    if (!dtCreateNavMeshData(&params, &data, &into.size)) {
        return false;
    }
    into.bytes.reset(data);
    into.polygons = m_mesh->npolys;
    return true;
}

} // namespace crowd::behavior
