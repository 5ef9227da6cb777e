// SPDX-License-Identifier: MIT
#include "model/pick/ScreenArea.h"

#include <limits>

namespace crowd::model {

ScreenArea ScreenArea::polygon(std::vector<glm::dvec2> corners)
{
    constexpr double kFar = std::numeric_limits<double>::infinity();
    glm::dvec2 low(kFar);
    glm::dvec2 high(-kFar);
    for (const glm::dvec2& corner : corners) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    ScreenArea area(low, high, -1.0);
    area.m_corners = std::make_shared<const std::vector<glm::dvec2>>(std::move(corners));
    return area;
}

/// Winding number by the edges that cross the horizontal line through the point; D. Sunday,
/// "Inclusion of a Point in a Polygon" (2001).
bool ScreenArea::windsRound(glm::dvec2 point) const
{
    const std::vector<glm::dvec2>& corners = *m_corners;
    int turns = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 a = corners[i];
        const glm::dvec2 b = corners[i + 1 < corners.size() ? i + 1 : 0];
        const double side = (b.x - a.x) * (point.y - a.y) - (point.x - a.x) * (b.y - a.y);
        if (a.y <= point.y && b.y > point.y && side > 0.0) {
            ++turns;
        } else if (a.y > point.y && b.y <= point.y && side < 0.0) {
            --turns;
        }
    }
    return turns != 0;
}

} // namespace crowd::model
