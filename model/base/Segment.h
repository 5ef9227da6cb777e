// SPDX-License-Identifier: MIT
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace crowd::model {

/// Where on the way from one point to another, 0..1, it is nearest to `point`; 0 where the two are
/// the same. Any frame.
[[nodiscard]] inline float nearestShare(const glm::vec3& point, const glm::vec3& from,
                                        const glm::vec3& to)
{
    const glm::vec3 along = to - from;
    const float length2 = glm::dot(along, along);
    return length2 > 0.0F ? glm::clamp(glm::dot(point - from, along) / length2, 0.0F, 1.0F) : 0.0F;
}

} // namespace crowd::model
