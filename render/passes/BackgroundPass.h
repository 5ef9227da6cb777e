// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "render/gl/GlObjects.h"
#include "render/gl/ShaderProgram.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

/// The ground plane with its grid, and the sky behind everything.
class BackgroundPass
{
public:
    [[nodiscard]] model::Result<void> initialize();
    /// Where nothing opaque was drawn before.
    void drawGround(const PassContext& context);
    void drawSky(const PassContext& context);

private:
    ShaderProgram m_sky;
    ShaderProgram m_ground;
    ShaderProgram m_grid;
    GlVertexArray m_nothing; ///< both make their corners themselves
};

} // namespace crowd::render
