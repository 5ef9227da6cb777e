// SPDX-License-Identifier: MIT
#include "behavior/surface/TriangleSoup.h"

#include <algorithm>
#include <cmath>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace crowd::behavior {

namespace {

constexpr float kAround = 15.0F;  ///< open ground about the stages and all others, metres
constexpr float kFurther = 50.0F; ///< that the ground goes on beyond that
constexpr float kFurtherShare = 0.1F;
constexpr float kFarthest = 2000.0F; ///< of places to reach, from the middle of the world
constexpr float kOnEarth = 1e7F;     ///< of what stages are made of

/// Coordinates that Recast can reckon with.
bool isOnEarth(const glm::vec3& point)
{
    return std::fabs(point.x) < kOnEarth && std::fabs(point.y) < kOnEarth &&
           std::fabs(point.z) < kOnEarth;
}

void addStage(const model::StageEntry& entry, TriangleSoup& soup)
{
    const glm::mat4 matrix = entry.worldFromStage();
    for (const model::StageMesh& mesh : entry.asset->meshes) {
        const auto first = static_cast<int>(soup.vertices.size() / 3);
        std::vector<bool> isSound;
        for (const glm::vec3& position : mesh.positions) {
            const glm::vec3 point = glm::vec3(matrix * glm::vec4(position, 1.0F));
            isSound.push_back(isOnEarth(point));
            soup.add(isSound.back() ? point : glm::vec3(0.0F));
            if (isSound.back()) {
                soup.stages.add(point);
            }
        }
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const std::uint32_t* corners = &mesh.indices[i];
            const bool isWhole = std::all_of(corners, corners + 3, [&](std::uint32_t corner) {
                return corner < isSound.size() && isSound[corner];
            });
            for (int corner = 0; corner < 3 && isWhole; ++corner) {
                soup.triangles.push_back(first + static_cast<int>(corners[corner]));
            }
        }
    }
}

model::Bounds widened(const model::Bounds& bounds)
{
    return {bounds.low - glm::vec3(kAround, 0.5F, kAround),
            bounds.high + glm::vec3(kAround, 2.5F, kAround)};
}

bool isInside(const model::Bounds& bounds, const glm::vec3& point)
{
    return point.x >= bounds.low.x && point.x <= bounds.high.x && point.y >= bounds.low.y &&
           point.y <= bounds.high.y && point.z >= bounds.low.z && point.z <= bounds.high.z;
}

/// The plane y = 0, further out than what is covered: nothing ends there.
void addGround(TriangleSoup& soup)
{
    const glm::vec3 size = soup.bounds.high - soup.bounds.low;
    const float further = kFurther + kFurtherShare * std::max(size.x, size.z);
    const glm::vec3 low = soup.bounds.low - further;
    const glm::vec3 high = soup.bounds.high + further;
    const auto first = static_cast<int>(soup.vertices.size() / 3);
    for (const glm::vec2& corner : {glm::vec2(low.x, low.z), glm::vec2(low.x, high.z),
                                    glm::vec2(high.x, high.z), glm::vec2(high.x, low.z)}) {
        soup.add({corner.x, 0.0F, corner.y});
    }
    for (const int index : {0, 1, 2, 0, 2, 3}) {
        soup.triangles.push_back(first + index);
    }
}

} // namespace

TriangleSoup soupOf(const SurfacePlan& plan)
{
    TriangleSoup soup;
    for (const model::StageEntry& entry : plan.stages) {
        if (entry.asset) {
            addStage(entry, soup);
        }
    }
    if (!soup.stages.isEmpty()) {
        soup.bounds = widened(soup.stages);
    }
    // Whoever is on the ground about the stages leaves the surface as it is.
    const model::Bounds covered = soup.bounds;
    for (const glm::vec3& point : plan.points) {
        if (std::fabs(point.x) < kFarthest && std::fabs(point.z) < kFarthest &&
            !isInside(covered, point)) {
            model::Bounds added;
            added.addPlace({point.x, std::clamp(point.y, -100.0F, 100.0F), point.z});
            if (!added.isEmpty()) {
                soup.bounds.add(widened(added));
            }
        }
    }
    if (!soup.bounds.isEmpty()) {
        soup.bounds.low.y = std::min(soup.bounds.low.y, -0.5F);
        soup.bounds.high.y = std::max(soup.bounds.high.y, 2.5F);
        addGround(soup);
    }
    return soup;
}

} // namespace crowd::behavior
