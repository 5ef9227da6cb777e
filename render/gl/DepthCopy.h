// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "model/view/View.h"
#include "render/gl/GlObjects.h"
#include "render/gl/PictureTarget.h"

namespace crowd::render {

/// What a picture has of depth so far, as a texture with a sample a pixel.
class DepthCopy
{
public:
    /// Leaves the target bound. False: the driver offers no such texture.
    [[nodiscard]] bool take(const PictureTarget& target);
    [[nodiscard]] const GlTexture& texture() const { return m_depth; }
    [[nodiscard]] glm::ivec2 size() const { return m_size; }

private:
    [[nodiscard]] bool make(glm::ivec2 size);

    glm::ivec2 m_size{0};
    bool m_isUsable = false;
    GlFramebuffer m_frame;
    GlTexture m_depth;
};

/// What makes metres of a depth of 0..1: half the width and height of what is seen a metre away (or
/// anywhere), and two numbers; see depth.glsl.
[[nodiscard]] glm::vec4 unprojectOf(const model::View& view);
/// Where the camera's axis is, beside the picture's middle: shares of half of the picture; not null
/// in parts of pictures.
[[nodiscard]] glm::vec2 axisOf(const model::View& view);

} // namespace crowd::render
