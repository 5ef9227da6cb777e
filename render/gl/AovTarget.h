// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include "model/base/Result.h"
#include "render/AovPicture.h"
#include "render/gl/GlObjects.h"

namespace crowd::render {

/// The framebuffer that places, normals and motion are drawn into, with one sample a pixel; see
/// aov.glsl.
class AovTarget
{
public:
    /// Made anew; bound, and empty.
    [[nodiscard]] model::Result<void> begin(glm::ivec2 size, bool hasMotion);
    /// What was drawn. The framebuffer goes: pictures are larger than anything else that is kept.
    [[nodiscard]] AovPicture take();

private:
    glm::ivec2 m_size{0};
    GlFramebuffer m_frame;
    GlRenderbuffer m_places;
    GlRenderbuffer m_normals;
    GlRenderbuffer m_before;
    bool m_hasMotion = false;
    GlRenderbuffer m_depth;
};

} // namespace crowd::render
