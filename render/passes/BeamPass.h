// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "render/gl/GlObjects.h"
#include "render/gl/ShaderVariants.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

/// What is seen of spotlights in the air: a cone of light each, added to what is behind it.
class BeamPass
{
public:
    void initialize();
    [[nodiscard]] static bool isNeeded(const PassContext& context);
    [[nodiscard]] model::Result<void> draw(const PassContext& context);

private:
    ShaderVariants m_programs{"beam"};
    GlVertexArray m_nothing; ///< corners are made by the shader
};

} // namespace crowd::render
