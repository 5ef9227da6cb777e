// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "behavior/surface/SurfacePlan.h"
#include "model/base/Bounds.h"

namespace crowd::behavior {

/// Triangles of stages and ground, as Recast wants them: three numbers a vertex, three vertices a
/// triangle. World frame, metres.
struct TriangleSoup
{
    std::vector<float> vertices;
    std::vector<int> triangles;
    model::Bounds stages; ///< what the stages alone fill
    model::Bounds bounds; ///< with the open ground about them

    void add(const glm::vec3& point)
    {
        vertices.insert(vertices.end(), {point.x, point.y, point.z});
    }
};

/// Those of a plan's stages, with open ground about them; empty where there is nothing to reach.
[[nodiscard]] TriangleSoup soupOf(const SurfacePlan& plan);

} // namespace crowd::behavior
