// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace crowd::model {

/// A circle, a rectangle or a closed polygon on screen; logical pixels, origin top left, y down.
/// Of a polygon that crosses itself, all that it winds round is inside.
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
    /// The corners in order; the last one is joined to the first. Fewer than three hold nothing
    /// but what lies on them.
    [[nodiscard]] static ScreenArea polygon(std::vector<glm::dvec2> corners);

    [[nodiscard]] bool isCircle() const { return m_radius >= 0.0; }
    [[nodiscard]] bool isPolygon() const { return m_polygon != nullptr; }
    [[nodiscard]] glm::dvec2 low() const { return m_low; }
    [[nodiscard]] glm::dvec2 high() const { return m_high; }
    [[nodiscard]] glm::dvec2 center() const { return (m_low + m_high) * 0.5; }
    [[nodiscard]] double radius() const { return m_radius; } ///< circles only
    [[nodiscard]] const std::vector<glm::dvec2>& corners() const
    {
        return m_polygon->corners;
    } ///< polygons

    [[nodiscard]] bool contains(glm::dvec2 point) const
    {
        if (isPolygon()) {
            return windsRound(point);
        }
        if (!isCircle()) {
            return point.x >= m_low.x && point.x <= m_high.x && point.y >= m_low.y &&
                   point.y <= m_high.y;
        }
        return squared(point - center()) <= m_radius * m_radius;
    }
    /// Whether all of a box lies inside; of a polygon it may say no where all of it does.
    [[nodiscard]] bool containsBox(glm::dvec2 boxLow, glm::dvec2 boxHigh) const
    {
        return !isPolygon() && contains(boxLow) && contains(boxHigh) &&
               contains({boxLow.x, boxHigh.y}) && contains({boxHigh.x, boxLow.y});
    }
    /// Whether any point of a box lies inside; of a polygon it may say yes where none does.
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
    /// Its edges by the rows of equal height that they come into, so that a point asks few of them.
    struct Polygon
    {
        std::vector<glm::dvec2> corners;
        std::vector<std::uint32_t> firstOfRow{}; ///< into `edges`; and the end
        std::vector<std::uint32_t> edges{};      ///< by their first corner
        double low = 0.0;                        ///< of the first row
        double rowsPerPixel = 0.0;

        void sortEdges(double height);
        [[nodiscard]] glm::dvec2 endOf(std::size_t edge) const
        {
            return corners[edge + 1 < corners.size() ? edge + 1 : 0];
        }
        [[nodiscard]] std::size_t rowOf(double y) const; ///< the nearest one
    };

    ScreenArea(glm::dvec2 low, glm::dvec2 high, double radius)
        : m_low(low), m_high(high), m_radius(radius)
    {
    }
    [[nodiscard]] static double squared(glm::dvec2 way) { return way.x * way.x + way.y * way.y; }
    [[nodiscard]] bool windsRound(glm::dvec2 point) const;

    glm::dvec2 m_low;
    glm::dvec2 m_high;
    double m_radius;
    std::shared_ptr<const Polygon> m_polygon; ///< null: no polygon
};

} // namespace crowd::model
