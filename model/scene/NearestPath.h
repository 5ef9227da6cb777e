// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "model/scene/Path.h"

namespace crowd::model {

struct Scene;

/// Says instead of a path's id: whichever path is nearest to where somebody is.
inline constexpr PathId kNearestPath = 0xFFFF'FFFFU;

/// Finds the path that passes nearest to a point. World frame, metres; between its places a path
/// runs straight. A copy of the places: the scene may change afterwards.
class NearestPath
{
public:
    explicit NearestPath(const Scene& scene);
    /// 0 where there is no path with a place; of two as near, the one listed first.
    [[nodiscard]] PathId at(const glm::vec3& position) const;

private:
    struct Leg
    {
        PathId path = 0;
        glm::vec3 from{0.0F};
        glm::vec3 to{0.0F};
    };
    std::vector<Leg> m_legs;
};

} // namespace crowd::model
