// SPDX-License-Identifier: MIT
#include "widgets/viewport/PointMark.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace crowd::widgets {

namespace {

constexpr float kRadiusShare = 0.02F; ///< of the distance from the camera
constexpr float kRings[] = {1.0F, 0.5F};
constexpr int kRingSides = 24;
constexpr float kMarkLift = 0.03F; ///< metres above the ground, which is not to hide it
const glm::vec4 kMarkColor{1.0F, 0.667F, 0.235F, 1.0F};

} // namespace

void addPointMark(std::vector<render::OverlayLine>& lines, const glm::vec3& at,
                  const model::Camera& camera)
{
    const float away = camera.projection == model::Projection::Perspective
                           ? glm::distance(camera.position, at)
                           : camera.orthographicHeight;
    const glm::vec3 center = at + glm::vec3(0.0F, kMarkLift, 0.0F);
    const float radius = kRadiusShare * away;
    for (const float ring : kRings) {
        const auto on = [&](int side) {
            const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(side) /
                                static_cast<float>(kRingSides);
            return center + ring * radius * glm::vec3(std::sin(angle), 0.0F, std::cos(angle));
        };
        for (int side = 0; side < kRingSides; ++side) {
            lines.push_back({on(side), on(side + 1), kMarkColor});
        }
    }
    // A pin that is seen where the ground is steep to the eye.
    lines.push_back(
        {center, center + glm::vec3(0.0F, 1.5F * radius, 0.0F), kMarkColor, 3.0F, 3.0F});
}

} // namespace crowd::widgets
