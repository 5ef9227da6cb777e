// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "render/gl/DepthCopy.h"
#include "render/gl/GlObjects.h"
#include "render/gl/ShaderVariants.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

/// What is seen of spotlights in the air: a cone of light each, added to what is behind it. Those
/// that cast shadows are cut by what stands in their light.
class BeamPass
{
public:
    void initialize();
    [[nodiscard]] static bool isNeeded(const PassContext& context);
    /// `depths`: of what is solid, which hides what is behind it little by little; null: at once.
    [[nodiscard]] model::Result<void> draw(const PassContext& context, const DepthCopy* depths);

private:
    [[nodiscard]] model::Result<void> drawOne(const PassContext& context, std::size_t index,
                                              const DepthCopy* depths);

    ShaderVariants m_programs{"beam"};
    GlVertexArray m_nothing; ///< corners are made by the shader
};

} // namespace crowd::render
