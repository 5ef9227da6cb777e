// SPDX-License-Identifier: MIT
#include "render/shadow/LampView.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace crowd::render {

namespace {

/// Texels around the cone: those that are blended at its edge.
constexpr float kBorderTexels = 3.0F;
/// Of the way to what it is turned to: what is nearer to the lamp belongs to it.
constexpr float kNearShare = 0.1F;
constexpr float kNearest = 0.05F; ///< metres
constexpr float kFarShare = 4.0F;
constexpr float kLeastFar = 40.0F; ///< metres

model::Camera cameraOf(const PlacedLight& light, float fovRadians)
{
    auto camera = model::Camera::lookingAt(light.position, light.position - light.axis);
    camera.fovYRadians = fovRadians;
    return camera;
}

} // namespace

LampView lampView(const PlacedLight& light, int pixels)
{
    const float half = std::min(light.coneRadians, kWidestCasterRadians) * 0.5F;
    const auto size = static_cast<float>(pixels);
    const float slope = std::tan(half) * size / (size - 2.0F * kBorderTexels);
    LampView lamp{model::View(cameraOf(light, 2.0F * std::atan(slope)), glm::vec2(size))};
    const float nearest = std::max(kNearest, kNearShare * light.reach);
    const float farthest = std::max(kLeastFar, kFarShare * light.reach);
    lamp.clipFromWorld = glm::perspectiveRH_NO(2.0F * std::atan(slope), 1.0F, nearest, farthest) *
                         lamp.view.viewMatrix();
    lamp.texelSlope = 2.0F * slope / size;
    return lamp;
}

} // namespace crowd::render
