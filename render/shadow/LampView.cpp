// SPDX-License-Identifier: MIT
#include "render/shadow/LampView.h"

#include <algorithm>
#include <array>
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

constexpr float kNearSide = 0.3F;  ///< metres: a lantern's glass stands in no light of its own
constexpr float kFarSide = 100.0F; ///< beyond, nothing is in shadow

constexpr std::array<glm::vec3, kLampSides> kSideWays{
    glm::vec3(1.0F, 0.0F, 0.0F),  glm::vec3(-1.0F, 0.0F, 0.0F), glm::vec3(0.0F, 1.0F, 0.0F),
    glm::vec3(0.0F, -1.0F, 0.0F), glm::vec3(0.0F, 0.0F, 1.0F),  glm::vec3(0.0F, 0.0F, -1.0F)};

/// `slope`: half a picture's width, a metre away.
LampView viewOf(const glm::vec3& from, const glm::vec3& way, float slope, glm::vec2 range,
                float pixels)
{
    const float fovRadians = 2.0F * std::atan(slope);
    auto camera = model::Camera::lookingAt(from, from + way);
    camera.fovYRadians = fovRadians;
    LampView lamp{model::View(camera, glm::vec2(pixels))};
    lamp.clipFromWorld =
        glm::perspectiveRH_NO(fovRadians, 1.0F, range.x, range.y) * lamp.view.viewMatrix();
    lamp.texelSlope = 2.0F * slope / pixels;
    return lamp;
}

} // namespace

LampView lampView(const PlacedLight& light, int pixels, std::size_t side)
{
    const auto size = static_cast<float>(pixels);
    const float border = size / (size - 2.0F * kBorderTexels);
    if (viewsOf(light) > 1) {
        return viewOf(light.position, kSideWays[side], border, {kNearSide, kFarSide}, size);
    }
    const float half = std::min(light.coneRadians, kWidestCasterRadians) * 0.5F;
    const glm::vec2 range(std::max(kNearest, kNearShare * light.reach),
                          std::max(kLeastFar, kFarShare * light.reach));
    return viewOf(light.position, -light.axis, std::tan(half) * border, range, size);
}

} // namespace crowd::render
