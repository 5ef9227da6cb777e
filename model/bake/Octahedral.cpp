// SPDX-License-Identifier: MIT
#include "model/bake/Octahedral.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace crowd::model {

namespace {

constexpr int kCodes = 255; ///< along each side of the square

/// Every code's direction: baking asks for four of them for each vertex of each keyframe.
const std::vector<glm::vec3>& decodedDirections()
{
    static const std::vector<glm::vec3> directions = [] {
        std::vector<glm::vec3> all;
        all.reserve(kCodes * kCodes);
        for (unsigned y = 0; y < kCodes; ++y) {
            for (unsigned x = 0; x < kCodes; ++x) {
                all.push_back(octahedralDecode(static_cast<std::uint16_t>(x | y << 8U)));
            }
        }
        return all;
    }();
    return directions;
}

/// Where a direction lies on the unfolded octahedron, 0 to 254 both ways.
glm::vec2 onSquare(const glm::vec3& n, float sum)
{
    glm::vec2 square = glm::vec2(n.x, n.y) / sum;
    if (n.z < 0.0F) {
        const glm::vec2 folded = 1.0F - glm::abs(glm::vec2(square.y, square.x));
        square = {square.x >= 0.0F ? folded.x : -folded.x, square.y >= 0.0F ? folded.y : -folded.y};
    }
    return (square + 1.0F) * 127.0F;
}

} // namespace

std::uint16_t octahedralEncode(const glm::vec3& n)
{
    const float sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    if (!(sum > 0.0F && sum <= std::numeric_limits<float>::max())) {
        return octahedralEncode(glm::vec3(0.0F, 1.0F, 0.0F));
    }
    const glm::vec2 place = onSquare(n, sum);
    const std::vector<glm::vec3>& directions = decodedDirections();
    int best = 0;
    float bestDot = -std::numeric_limits<float>::infinity();
    for (int corner = 0; corner < 4; ++corner) {
        const int x = std::min(static_cast<int>(place.x) + (corner & 1), kCodes - 1);
        const int y = std::min(static_cast<int>(place.y) + (corner >> 1), kCodes - 1);
        const float dot = glm::dot(directions[static_cast<std::size_t>(y * kCodes + x)], n);
        if (dot > bestDot) {
            bestDot = dot;
            best = x | y << 8;
        }
    }
    return static_cast<std::uint16_t>(best);
}

} // namespace crowd::model
