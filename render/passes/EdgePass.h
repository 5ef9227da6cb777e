// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "model/base/Result.h"
#include "render/gl/GlObjects.h"
#include "render/gl/ShaderVariants.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

/// Smooth edges of a finished picture, found by what differs from pixel to pixel.
class EdgePass
{
public:
    void initialize();
    [[nodiscard]] static bool isNeeded(const PassContext& context);
    /// Over the bound framebuffer, which has the same picture, from a texture of it.
    [[nodiscard]] model::Result<void> draw(const PassContext& context, std::uint32_t picture);

private:
    [[nodiscard]] model::Result<void> drawOne(const PassContext& context, const char* defines);

    ShaderVariants m_programs{"edges"};
    GlVertexArray m_nothing;
};

} // namespace crowd::render
