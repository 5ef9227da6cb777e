// SPDX-License-Identifier: MIT
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "model/scene/Scene.h"

namespace crowd::render {

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
    /// Luminance of what sun and sky give to a surface that faces both; never 0.
    [[nodiscard]] float fullLuminance() const;
    /// Light on an upward surface.
    [[nodiscard]] glm::vec3 onGround() const { return sun * glm::max(sunDirection.y, 0.0F) + sky; }
};

} // namespace crowd::render
