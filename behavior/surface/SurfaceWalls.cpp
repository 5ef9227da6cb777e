// SPDX-License-Identifier: MIT
#include "behavior/surface/SurfaceWalls.h"

#include <algorithm>
#include <cmath>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <recastnavigation/Recast.h>

namespace crowd::behavior {

std::vector<Wall> wallsOf(const rcPolyMesh& mesh, const model::SurfaceSettings& settings)
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
            // Whoever stands beyond it may come back.
            walls.push_back({glm::vec2(b.x, b.z) - out, glm::vec2(a.x, a.z) - out,
                             std::min(a.y, b.y) - 1.0F, std::max(a.y, b.y) + 1.0F, true});
        }
    }
    return walls;
}

} // namespace crowd::behavior
