// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace crowd::behavior {

/// Where on a surface somebody walks.
struct Footing
{
    std::uint32_t polygon = 0; ///< 0: nowhere
    glm::vec3 point{0.0F};     ///< of the polygon, nearest to him; world frame, metres
};

/// Where in the width of a flow somebody walks. Metres.
struct Lane
{
    glm::vec2 side{0.0F}; ///< from its middle, in the unit disk
    float width = 0.0F;   ///< of the flow
};

} // namespace crowd::behavior
