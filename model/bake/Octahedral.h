// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

/// Unit vectors in two bytes (Cigolle et al. 2014, "A Survey of Efficient Representations for
/// Independent Unit Vectors"): the octahedron unfolded onto a square, 127 steps to either side of
/// zero, so that the axes are exact. The vertex shader decodes the same way.
namespace crowd::model {

[[nodiscard]] inline glm::vec3 octahedralDecode(std::uint16_t packed)
{
    const glm::vec2 square = glm::vec2(packed & 0xFFU, packed >> 8U) / 127.0F - 1.0F;
    glm::vec3 n(square, 1.0F - std::abs(square.x) - std::abs(square.y));
    const float fold = glm::max(-n.z, 0.0F);
    n.x += n.x >= 0.0F ? -fold : fold;
    n.y += n.y >= 0.0F ? -fold : fold;
    return glm::normalize(n);
}

/// The best of the four codes around the exact place; at most about a degree off. Anything that is
/// no direction becomes up.
[[nodiscard]] std::uint16_t octahedralEncode(const glm::vec3& n);

} // namespace crowd::model
