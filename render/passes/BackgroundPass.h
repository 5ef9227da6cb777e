// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "render/gl/GlObjects.h"
#include "render/gl/ShaderProgram.h"
#include "render/gl/ShaderVariants.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

/// The ground plane with its grid, and the sky behind everything.
class BackgroundPass
{
public:
    [[nodiscard]] model::Result<void> initialize();
    /// Where nothing opaque was drawn before.
    [[nodiscard]] model::Result<void> drawGround(const PassContext& context);
    void drawSky(const PassContext& context);

private:
    ShaderProgram m_sky;
    ShaderVariants m_ground{"ground"};
    GlVertexArray m_nothing; ///< both make their corners themselves
};

} // namespace crowd::render
