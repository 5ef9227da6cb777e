// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "render/gl/DepthCopy.h"
#include "render/gl/GlObjects.h"
#include "render/gl/ShaderVariants.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

/// Lines of ink around people and things, and along creases, by the depth of what is drawn so far.
class InkPass
{
public:
    void initialize();
    [[nodiscard]] model::Result<void> draw(const PassContext& context, const DepthCopy& depths);

private:
    ShaderVariants m_programs{"ink"};
    GlVertexArray m_nothing;
};

} // namespace crowd::render
