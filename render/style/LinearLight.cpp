// SPDX-License-Identifier: MIT
#include "render/style/LinearLight.h"

#include <cmath>

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

} // namespace crowd::render
