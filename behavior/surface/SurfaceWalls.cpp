// SPDX-License-Identifier: MIT
#include "behavior/surface/SurfaceWalls.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <recastnavigation/DetourNavMesh.h>

namespace crowd::behavior {

namespace {

constexpr float kRim = 1.0F;         ///< metres, beside a body, by which the covered ground ends
constexpr float kLinkSteps = 255.0F; ///< that Detour counts along an edge
constexpr float kLeastOpen = 0.02F;  ///< of an edge: less between two tiles is how they are rounded

using Span = std::pair<float, float>; // of an edge, 0..1

/// What of an edge no other polygon goes on from.
std::vector<Span> openSpans(const dtMeshTile& tile, const dtPoly& polygon, unsigned edge)
{
    const unsigned short neighbour = polygon.neis[edge];
    if (neighbour != 0 && (neighbour & DT_EXT_LINK) == 0) {
        return {};
    }
    std::vector<Span> linked;
    for (unsigned i = polygon.firstLink; i != DT_NULL_LINK && neighbour != 0;
         i = tile.links[i].next) {
        const dtLink& link = tile.links[i];
        if (link.edge == edge && link.side != 0xff) {
            linked.emplace_back(static_cast<float>(link.bmin) / kLinkSteps,
                                static_cast<float>(link.bmax) / kLinkSteps);
        }
    }
    std::ranges::sort(linked);
    std::vector<Span> open;
    float at = 0.0F;
    linked.emplace_back(1.0F, 1.0F);
    for (const Span& next : linked) {
        if (next.first - at > kLeastOpen) {
            open.emplace_back(at, next.first);
        }
        at = std::max(at, next.second);
    }
    return open;
}

class WallFinder
{
public:
    WallFinder(const model::Bounds& covered, float radius) : m_covered(covered), m_radius(radius) {}

    void add(const dtMeshTile& tile, const dtPoly& polygon)
    {
        const auto corner = [&tile, &polygon](unsigned i) {
            const float* v = &tile.verts[polygon.verts[i] * 3];
            return glm::vec3(v[0], v[1], v[2]);
        };
        for (unsigned edge = 0; edge < polygon.vertCount; ++edge) {
            const glm::vec3 a = corner(edge);
            const glm::vec3 b = corner(edge + 1U < polygon.vertCount ? edge + 1U : 0U);
            for (const Span& span : openSpans(tile, polygon, edge)) {
                add(glm::mix(a, b, span.first), glm::mix(a, b, span.second));
            }
        }
    }
    [[nodiscard]] std::vector<Wall> take() { return std::move(m_walls); }

private:
    [[nodiscard]] bool isOnRim(const glm::vec3& corner) const
    {
        const float margin = m_radius + kRim;
        return corner.x < m_covered.low.x + margin || corner.x > m_covered.high.x - margin ||
               corner.z < m_covered.low.z + margin || corner.z > m_covered.high.z - margin;
    }
    void add(const glm::vec3& a, const glm::vec3& b)
    {
        if (isOnRim(a) && isOnRim(b)) {
            return; // the open ground goes on
        }
        // The surface ends a body's radius before what stands there.
        const glm::vec2 along(b.x - a.x, b.z - a.z);
        const float length = std::sqrt(along.x * along.x + along.y * along.y);
        if (length < 1e-4F) {
            return;
        }
        const glm::vec2 out = glm::vec2(along.y, -along.x) / length * m_radius;
        // Whoever stands beyond it may come back.
        m_walls.push_back({glm::vec2(b.x, b.z) - out, glm::vec2(a.x, a.z) - out,
                           std::min(a.y, b.y) - 1.0F, std::max(a.y, b.y) + 1.0F, true});
    }

    model::Bounds m_covered;
    float m_radius;
    std::vector<Wall> m_walls;
};

} // namespace

std::vector<Wall> wallsOf(const dtNavMesh& mesh, const model::Bounds& covered,
                          const model::SurfaceSettings& settings)
{
    WallFinder finder(covered, settings.radius);
    for (int i = 0; i < mesh.getMaxTiles(); ++i) {
        const dtMeshTile& tile = *mesh.getTile(i);
        for (int p = 0; tile.header != nullptr && p < tile.header->polyCount; ++p) {
            finder.add(tile, tile.polys[p]);
        }
    }
    return finder.take();
}

} // namespace crowd::behavior
