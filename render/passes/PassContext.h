// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/RenderInput.h"

namespace crowd::render {

class ShaderProgram;

/// Lighting in linear light, as the shaders want it.
struct LinearLight
{
    glm::vec3 sunDirection{0.0F, 1.0F, 0.0F}; ///< towards the sun
    glm::vec3 sun{1.0F};
    glm::vec3 sky{0.5F};
    glm::vec3 bounce{0.2F};
    glm::vec3 zenith{0.3F, 0.5F, 0.8F};
    glm::vec3 horizon{0.8F};
    glm::vec3 ground{0.5F}; ///< base colour of the plane

    [[nodiscard]] static LinearLight from(const model::Lighting& lighting);
    /// Light on an upward surface.
    [[nodiscard]] glm::vec3 onGround() const { return sun * glm::max(sunDirection.y, 0.0F) + sky; }
};

/// What every pass of a picture shares; lives for one draw().
struct PassContext
{
    const RenderInput& input;
    glm::mat4 viewProjection;
    LinearLight light;
    glm::ivec2 pixelSize;
    bool isSoftware = false; ///< llvmpipe: work is handed over in small pieces
    RenderStatistics& statistics;

    /// Camera and light of a program in use.
    void setCommon(ShaderProgram& program) const;
    void countDraw(std::int64_t triangles) const;
};

} // namespace crowd::render
