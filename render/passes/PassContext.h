// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "render/RenderInput.h"
#include "render/style/Style.h"

namespace crowd::render {

class ShaderProgram;

/// What every pass of a picture shares; lives for one draw().
struct PassContext
{
    const RenderInput& input;
    glm::mat4 viewProjection;
    Style style;
    glm::ivec2 pixelSize;
    bool isSoftware = false; ///< llvmpipe: work is handed over in small pieces
    RenderStatistics& statistics;

    /// Camera and light of a program in use.
    void setCommon(ShaderProgram& program) const;
    void countDraw(std::int64_t triangles) const;
};

} // namespace crowd::render
