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

/// The best of the four codes around the exact place; at most about a degree off.
[[nodiscard]] inline std::uint16_t octahedralEncode(const glm::vec3& n)
{
    const float sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    if (!(sum > 0.0F)) {
        return octahedralEncode(glm::vec3(0.0F, 1.0F, 0.0F));
    }
    glm::vec2 square = glm::vec2(n.x, n.y) / sum;
    if (n.z < 0.0F) {
        const glm::vec2 folded = 1.0F - glm::abs(glm::vec2(square.y, square.x));
        square = {square.x >= 0.0F ? folded.x : -folded.x, square.y >= 0.0F ? folded.y : -folded.y};
    }
    const glm::vec2 low = glm::floor((square + 1.0F) * 127.0F);
    std::uint16_t best = 0;
    float bestDot = -2.0F;
    for (int corner = 0; corner < 4; ++corner) {
        const float x = glm::min(low.x + static_cast<float>(corner & 1), 254.0F);
        const float y = glm::min(low.y + static_cast<float>(corner >> 1), 254.0F);
        const auto code =
            static_cast<std::uint16_t>(static_cast<unsigned>(x) | static_cast<unsigned>(y) << 8U);
        const float dot = glm::dot(octahedralDecode(code), n);
        if (dot > bestDot) {
            bestDot = dot;
            best = code;
        }
    }
    return best;
}

} // namespace crowd::model
