// SPDX-License-Identifier: MIT
#include "widgets/viewport/AreaSlices.h"

#include <algorithm>

#include <glm/common.hpp>

namespace crowd::widgets {

namespace {

constexpr float kThinnest = 1e-3F; ///< metres

/// Part of a side that goes through a slice: where it enters and where it leaves.
struct Crossing
{
    glm::vec3 from{0.0F};
    glm::vec3 to{0.0F};
};

std::vector<Crossing> crossingsOf(std::span<const glm::vec3> corners, float low, float high)
{
    std::vector<Crossing> crossings;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        glm::vec3 a = corners[i];
        glm::vec3 b = corners[(i + 1) % corners.size()];
        if (a.z > b.z) {
            std::swap(a, b);
        }
        if (a.z <= low && b.z >= high) {
            const auto at = [&](float z) { return glm::mix(a, b, (z - a.z) / (b.z - a.z)); };
            crossings.push_back({at(low), at(high)});
        }
    }
    std::ranges::sort(crossings, [](const Crossing& a, const Crossing& b) {
        return a.from.x + a.to.x < b.from.x + b.to.x;
    });
    return crossings;
}

} // namespace

std::vector<BandShape> slicesOf(std::span<const glm::vec3> corners)
{
    std::vector<float> cuts;
    cuts.reserve(corners.size());
    for (const glm::vec3& corner : corners) {
        cuts.push_back(corner.z);
    }
    std::ranges::sort(cuts);
    std::vector<BandShape> slices;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        if (cuts[i + 1] - cuts[i] < kThinnest) {
            continue;
        }
        const std::vector<Crossing> sides = crossingsOf(corners, cuts[i], cuts[i + 1]);
        for (std::size_t s = 0; s + 1 < sides.size(); s += 2) {
            const Crossing& left = sides[s];
            const Crossing& right = sides[s + 1];
            BandShape& slice = slices.emplace_back();
            slice.from = 0.5F * (left.from + right.from);
            slice.to = 0.5F * (left.to + right.to);
            // Aside is to the east, straight across: the middle line may go askew.
            slice.to.x = slice.from.x;
            slice.fromAside = {left.from.x - slice.from.x, right.from.x - slice.from.x};
            slice.toAside = {left.to.x - slice.from.x, right.to.x - slice.from.x};
        }
    }
    return slices;
}

} // namespace crowd::widgets
