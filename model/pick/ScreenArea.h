// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace crowd::model {

/// A circle or a rectangle on screen; logical pixels, origin top left, y down.
class ScreenArea
{
public:
    [[nodiscard]] static ScreenArea circle(glm::dvec2 center, double radius)
    {
        return {center - radius, center + radius, radius};
    }
    /// Any two opposite corners.
    [[nodiscard]] static ScreenArea rectangle(glm::dvec2 a, glm::dvec2 b)
    {
        return {glm::min(a, b), glm::max(a, b), -1.0};
    }

    [[nodiscard]] bool isCircle() const { return m_radius >= 0.0; }
    [[nodiscard]] glm::dvec2 low() const { return m_low; }
    [[nodiscard]] glm::dvec2 high() const { return m_high; }
    [[nodiscard]] glm::dvec2 center() const { return (m_low + m_high) * 0.5; }
    [[nodiscard]] double radius() const { return m_radius; } ///< circles only

    [[nodiscard]] bool contains(glm::dvec2 point) const
    {
        if (!isCircle()) {
            return point.x >= m_low.x && point.x <= m_high.x && point.y >= m_low.y &&
                   point.y <= m_high.y;
        }
        return squared(point - center()) <= m_radius * m_radius;
    }
    /// Whether any point of a box lies inside.
    [[nodiscard]] bool touches(glm::dvec2 boxLow, glm::dvec2 boxHigh) const
    {
        if (boxHigh.x < m_low.x || boxLow.x > m_high.x || boxHigh.y < m_low.y ||
            boxLow.y > m_high.y) {
            return false;
        }
        return !isCircle() ||
               squared(glm::clamp(center(), boxLow, boxHigh) - center()) <= m_radius * m_radius;
    }

private:
    ScreenArea(glm::dvec2 low, glm::dvec2 high, double radius)
        : m_low(low), m_high(high), m_radius(radius)
    {
    }
    [[nodiscard]] static double squared(glm::dvec2 way) { return way.x * way.x + way.y * way.y; }

    glm::dvec2 m_low;
    glm::dvec2 m_high;
    double m_radius;
};

} // namespace crowd::model
