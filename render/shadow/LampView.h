// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat4x4.hpp>

#include "model/view/View.h"
#include "render/style/PlacedLight.h"

/// How a spotlight looks at what it lights. No GL.
namespace crowd::render {

/// A perspective picture of all within its cone. World frame, metres.
struct LampView
{
    model::View view;              ///< whose pixels are the shadow map's texels
    glm::mat4 clipFromWorld{1.0F}; ///< the view's, with the depths that it reaches alone
    float texelSlope = 0.0F;       ///< metres that a texel is wide a metre away from the lamp
};

/// Of one that has a cone no wider than kWidestCasterRadians; on a square of `pixels`.
[[nodiscard]] LampView lampView(const PlacedLight& light, int pixels);

} // namespace crowd::render
