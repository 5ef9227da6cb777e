// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "render/gl/GlObjects.h"
#include "render/gl/ShaderVariants.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

/// The ground plane with its grid, and the sky behind everything.
class BackgroundPass
{
public:
    void initialize();
    /// Where nothing opaque was drawn before.
    [[nodiscard]] model::Result<void> drawGround(const PassContext& context);
    [[nodiscard]] model::Result<void> drawSky(const PassContext& context);

private:
    ShaderVariants m_sky{"sky"};
    ShaderVariants m_ground{"ground"};
    GlVertexArray m_nothing; ///< both make their corners themselves
};

} // namespace crowd::render
