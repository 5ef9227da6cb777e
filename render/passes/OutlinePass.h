// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "model/base/Result.h"
#include "render/crowd/CrowdGpu.h"
#include "render/crowd/CrowdPlan.h"
#include "render/gl/GlObjects.h"
#include "render/gl/ShaderProgram.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

/// Outlines of who is highlighted, found in the finished picture: who it is stands in its alpha
/// (crowd.vert). Costs the same for one and for everybody.
class OutlinePass
{
public:
    [[nodiscard]] model::Result<void> initialize();
    /// Over the framebuffer that is bound, which has the picture already, encoded; makes it opaque.
    void draw(const PassContext& context, std::uint32_t picture, const CrowdGpu& crowd,
              const CrowdPlan& plan);

private:
    ShaderProgram m_program;
    GlVertexArray m_nothing;
};

} // namespace crowd::render
