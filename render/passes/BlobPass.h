// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "render/crowd/CrowdGpu.h"
#include "render/crowd/CrowdView.h"
#include "render/gl/GlObjects.h"
#include "render/gl/ShaderProgram.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

/// The soft dark under people's feet.
class BlobPass
{
public:
    [[nodiscard]] model::Result<void> initialize();
    void draw(const PassContext& context, const CrowdRows& rows, const CrowdView& view);

private:
    ShaderProgram m_program;
    GlVertexArray m_array;
    GlBuffer m_corners;
};

} // namespace crowd::render
