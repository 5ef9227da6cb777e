// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <glm/mat4x4.hpp>

#include "model/view/View.h"
#include "render/style/PlacedLight.h"

/// How a lamp looks at what it lights. No GL.
namespace crowd::render {

/// A perspective picture of all within its cone, or of one of the six sides of a lamp that shines
/// to all of them. World frame, metres.
struct LampView
{
    model::View view;              ///< whose pixels are the shadow map's texels
    glm::mat4 clipFromWorld{1.0F}; ///< the view's, with the depths that it reaches alone
    float texelSlope = 0.0F;       ///< metres that a texel is wide a metre away from the lamp
};

/// Where a lamp without a cone looks: +X, -X, +Y, -Y, +Z, -Z. A cube's sides.
inline constexpr std::size_t kLampSides = 6;

/// How many views it takes to see all that a lamp lights.
[[nodiscard]] constexpr std::size_t viewsOf(const PlacedLight& light)
{
    return light.coneRadians > 0.0F ? 1 : kLampSides;
}

/// Of one that has a cone no wider than kWidestCasterRadians, or of a side, below viewsOf(); on a
/// square of `pixels`.
[[nodiscard]] LampView lampView(const PlacedLight& light, int pixels, std::size_t side = 0);

} // namespace crowd::render
