// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace crowd::render {

/// What a picture shows instead of how it looks (arbitrary output variables, as renderers call
/// them): of each pixel the surface at its centre. Rows from the top; world frame, metres. Seen
/// through: what is blended of stages, such as glass, and of people where it hides less than half.
struct AovPicture
{
    static constexpr std::int32_t kThing = -1;   ///< a row: stages, the ground
    static constexpr std::int32_t kNothing = -2; ///< a row: the sky; place and normal are zero

    glm::ivec2 size{0};
    std::vector<glm::vec3> places;
    std::vector<glm::vec3> normals; ///< unit, towards who looks
    std::vector<std::int32_t> rows; ///< of the frame's population
    /// Where the same point of the surface was at the earlier moment, as a way from here: pixels,
    /// right and up. The sky is far away: it moves as the camera turns. Who was not there then has
    /// not moved. Empty where no earlier moment is given.
    std::vector<glm::vec2> before;
};

} // namespace crowd::render
