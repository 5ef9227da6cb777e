// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "model/base/Bounds.h"
#include "model/view/View.h"

/// How the sun looks at what a camera sees. No GL.
namespace crowd::render {

/// One orthographic picture of all that may throw a shadow on what is seen. World frame, metres.
struct SunView
{
    model::View view;         ///< whose pixels are the shadow map's texels, save for its aspect
    float texelMetres = 0.0F; ///< of the longer side
    glm::vec2 metres{1.0F};   ///< that the map is wide and high
    glm::mat4 clipFromWorld{1.0F}; ///< the view's, with the depth of the scene alone
    glm::mat4 mapFromWorld{1.0F};  ///< 0..1 on the map, and the depth that it holds
};

/// One of the eight corners of a box: bits 0, 1, 2 choose the high end of X, Y, Z.
[[nodiscard]] glm::vec3 cornerOf(const model::Bounds& box, unsigned corner);

/// `seen`: what may receive shadows; `farMetres`: beyond it none are received. Steps in whole
/// texels, so that edges of shadows do not crawl while the camera moves. Nothing where the camera
/// sees none of it.
[[nodiscard]] std::optional<SunView> fitSunView(const model::View& camera, float farMetres,
                                                const model::Bounds& seen, const glm::vec3& toSun,
                                                int mapPixels);

} // namespace crowd::render
