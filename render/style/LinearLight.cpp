// SPDX-License-Identifier: MIT
#include "render/style/LinearLight.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/base/Color.h"

namespace crowd::render {

namespace {

constexpr float kBounce = 0.7F; ///< share of the ambient light that the ground throws back

} // namespace

LinearLight LinearLight::from(const model::Lighting& lighting)
{
    LinearLight light;
    const float level = std::cos(lighting.sunElevationRadians);
    light.sunDirection = {std::sin(lighting.sunAzimuthRadians) * level,
                          std::sin(lighting.sunElevationRadians),
                          std::cos(lighting.sunAzimuthRadians) * level};
    light.sun = model::linearFromSrgb(lighting.sunColor) * lighting.sunStrength;
    light.sky = model::linearFromSrgb(lighting.ambientColor) * lighting.ambientStrength;
    light.ground = model::linearFromSrgb(lighting.ground);
    light.bounce = light.sky * light.ground * kBounce + light.ground * light.sun * 0.1F;
    light.zenith = model::linearFromSrgb(lighting.skyZenith);
    light.horizon = model::linearFromSrgb(lighting.skyHorizon);
    return light;
}

float LinearLight::fullLuminance() const
{
    return std::max(glm::dot(sun + sky, glm::vec3(0.2126F, 0.7152F, 0.0722F)), 1e-3F);
}

} // namespace crowd::render
