// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "model/base/Result.h"
#include "render/gl/GlObjects.h"
#include "render/gl/ShaderProgram.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

/// A part of the picture, physical pixels from below left.
struct PixelRect
{
    glm::ivec2 low{0};
    glm::ivec2 high{0}; ///< not in it any more
    [[nodiscard]] bool isEmpty() const { return low.x >= high.x || low.y >= high.y; }
};

/// Outlines of who is highlighted, found in the finished picture: who it is stands in its alpha
/// (crowd.vert). Costs the same for one and for everybody.
class OutlinePass
{
public:
    [[nodiscard]] model::Result<void> initialize();
    /// Over the framebuffer that is bound, which has the picture already, encoded; makes it opaque.
    void draw(const PassContext& context, std::uint32_t picture, const PixelRect& part);

private:
    ShaderProgram m_program;
    GlVertexArray m_nothing;
};

} // namespace crowd::render
