// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include "behavior/surface/TriangleSoup.h"

namespace crowd::behavior {

/// How a surface is cut into square tiles, each of which is built by itself, so that cells are
/// small where there is something to walk around: flat ground is the same in large ones. World
/// frame, metres; (x, z).
struct SurfaceTiles
{
    glm::vec2 origin{0.0F}; ///< the corner with the lowest coordinates
    float side = 32.0F;
    int columns = 0; ///< along x
    int rows = 0;    ///< along z
    float cellHeight = 0.05F;
    std::vector<std::vector<std::size_t>> triangles; ///< of the soup, by tile
    std::vector<float> cells;                        ///< width of its cells, by tile

    /// `coarser`: by how much cells are wider than they would be, where that was too many.
    [[nodiscard]] static SurfaceTiles of(const TriangleSoup& soup, const SurfacePlan& plan,
                                         float coarser);

    [[nodiscard]] std::size_t count() const { return cells.size(); }
    [[nodiscard]] glm::vec2 low(std::size_t tile) const
    {
        const auto across = static_cast<std::size_t>(columns);
        return origin + side * glm::vec2(static_cast<float>(tile % across),
                                         static_cast<float>(tile / across));
    }
};

} // namespace crowd::behavior
