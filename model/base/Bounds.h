// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace crowd::model {

/// Axis-aligned box; empty until something is added.
struct Bounds
{
    glm::vec3 low{std::numeric_limits<float>::infinity()};
    glm::vec3 high{-std::numeric_limits<float>::infinity()};

    [[nodiscard]] bool isEmpty() const { return low.x > high.x; }
    [[nodiscard]] glm::vec3 center() const { return (low + high) * 0.5F; }
    [[nodiscard]] glm::vec3 size() const { return isEmpty() ? glm::vec3(0.0F) : high - low; }
    void add(const glm::vec3& point)
    {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    /// Leaves out what is no place in any scene: infinities, no numbers, light years.
    void addPlace(const glm::vec3& point)
    {
        if (isPlace(point)) {
            add(point);
        }
    }
    [[nodiscard]] static bool isPlace(const glm::vec3& point)
    {
        constexpr float kFarthest = 1e12F;
        const glm::vec3 away = glm::abs(point);
        return away.x < kFarthest && away.y < kFarthest && away.z < kFarthest;
    }
    void add(const Bounds& other)
    {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
};

} // namespace crowd::model
