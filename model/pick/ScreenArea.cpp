// SPDX-License-Identifier: MIT
#include "model/pick/ScreenArea.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

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
    Polygon polygon{std::move(corners)};
    polygon.low = low.y;
    polygon.sortEdges(high.y - low.y);
    area.m_polygon = std::make_shared<const Polygon>(std::move(polygon));
    return area;
}

std::size_t ScreenArea::Polygon::rowOf(double y) const
{
    const auto last = static_cast<double>(firstOfRow.size() - 2);
    return static_cast<std::size_t>(std::clamp((y - low) * rowsPerPixel, 0.0, last));
}

/// So many rows that an edge is in two of them on average, whatever way the edges run.
void ScreenArea::Polygon::sortEdges(double height)
{
    constexpr double kMostRows = 4096.0;
    double climbs = 0.0; // pixels, of all edges
    for (std::size_t i = 0; i < corners.size(); ++i) {
        climbs += std::abs(endOf(i).y - corners[i].y);
    }
    const double wanted =
        climbs > 0.0 ? static_cast<double>(corners.size()) * height / climbs : 1.0;
    const double rows = std::floor(std::clamp(wanted, 1.0, kMostRows));
    rowsPerPixel = height > 0.0 ? rows / height : 0.0;
    firstOfRow.assign(static_cast<std::size_t>(rows) + 1, 0);
    const auto forEachRow = [this](std::size_t edge, const auto& visit) {
        const double begin = corners[edge].y;
        const double end = endOf(edge).y;
        const std::size_t last = rowOf(std::max(begin, end));
        for (std::size_t row = rowOf(std::min(begin, end)); row <= last; ++row) {
            visit(row);
        }
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
        forEachRow(i, [this](std::size_t row) { ++firstOfRow[row + 1]; });
    }
    std::partial_sum(firstOfRow.begin(), firstOfRow.end(), firstOfRow.begin());
    edges.resize(firstOfRow.back());
    std::vector<std::uint32_t> next(firstOfRow.begin(), firstOfRow.end() - 1);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        forEachRow(i, [&](std::size_t row) { edges[next[row]++] = static_cast<std::uint32_t>(i); });
    }
}

/// Winding number by the edges that cross the horizontal line through the point; D. Sunday,
/// "Inclusion of a Point in a Polygon" (2001).
bool ScreenArea::windsRound(glm::dvec2 point) const
{
    if (!(point.x >= m_low.x && point.x <= m_high.x && point.y >= m_low.y && point.y <= m_high.y)) {
        return false;
    }
    const Polygon& polygon = *m_polygon;
    const std::size_t row = polygon.rowOf(point.y);
    int turns = 0;
    for (std::uint32_t i = polygon.firstOfRow[row]; i < polygon.firstOfRow[row + 1]; ++i) {
        const glm::dvec2 a = polygon.corners[polygon.edges[i]];
        const glm::dvec2 b = polygon.endOf(polygon.edges[i]);
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
