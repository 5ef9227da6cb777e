// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>
#include <recastnavigation/DetourNavMesh.h>

#include "behavior/surface/TriangleSoup.h"

namespace crowd::behavior {

/// Which polygons belong to the ground. That is what is linked to the open ground about the stages,
/// and floors: large parts of the lower half of the stages that nothing leads to. Roofs, crowns of
/// trees and basins are not, nor is the inside of a solid body, such as a house that is only walls
/// and roof as seen from outside. World frame, metres. Immutable; any thread.
class SurfaceGround
{
public:
    SurfaceGround() = default;
    SurfaceGround(const dtNavMesh& mesh, const TriangleSoup& soup);

    [[nodiscard]] bool holds(dtPolyRef polygon) const;
    /// What belongs to it, a cell's height lower than the mesh lies: as what it was made from.
    [[nodiscard]] std::vector<std::array<glm::vec3, 3>> triangles(float cellHeight) const;
    /// How many there are in all, of the ground or not.
    [[nodiscard]] std::size_t polygons() const { return m_isGround.size(); }

private:
    const dtNavMesh* m_mesh = nullptr;
    std::vector<std::size_t> m_first; ///< number of its first polygon, by tile
    std::vector<char> m_isGround;     ///< by number of the polygon
};

} // namespace crowd::behavior
