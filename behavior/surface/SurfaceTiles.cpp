// SPDX-License-Identifier: MIT
#include "behavior/surface/SurfaceTiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace crowd::behavior {

namespace {

constexpr float kTileSide = 32.0F;
constexpr float kMostTilesASide = 32.0F;
constexpr float kFinestCell = 0.1F;
constexpr double kMostCells = 4e6;       ///< of all tiles that are not flat
constexpr float kFlatCellsASide = 32.0F; ///< of a tile where nothing stands
constexpr float kBeside = 2.0F;          ///< metres about a tile that are built with it, at most
constexpr float kFlatMetres = 0.03F;     ///< so much of a height is none
constexpr std::size_t kMostFloors = 16;
constexpr float kWholeShare = 0.001F; ///< by which what covers a tile may miss its area
constexpr float kMostLevels = 8000.0F;

struct Square
{
    glm::vec2 low;
    glm::vec2 high;
};

glm::vec3 vertexOf(const TriangleSoup& soup, std::size_t triangle, std::size_t corner)
{
    const auto vertex = static_cast<std::size_t>(soup.triangles[triangle * 3 + corner]) * 3;
    return {soup.vertices[vertex], soup.vertices[vertex + 1], soup.vertices[vertex + 2]};
}

/// What is on one side of a line across an axis.
std::vector<glm::vec2> cut(const std::vector<glm::vec2>& polygon, int axis, float at, float side)
{
    std::vector<glm::vec2> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::vec2& a = polygon[i];
        const glm::vec2& b = polygon[(i + 1) % polygon.size()];
        const float fromA = (a[axis] - at) * side;
        const float fromB = (b[axis] - at) * side;
        if (fromA >= 0.0F) {
            kept.push_back(a);
        }
        if ((fromA >= 0.0F) != (fromB >= 0.0F)) {
            kept.push_back(a + (b - a) * (fromA / (fromA - fromB)));
        }
    }
    return kept;
}

/// m² of a triangle in a square, as seen from above (I. Sutherland, G. Hodgman, 1974).
double areaWithin(const std::array<glm::vec3, 3>& triangle, const Square& square)
{
    std::vector<glm::vec2> polygon;
    polygon.reserve(triangle.size());
    for (const glm::vec3& corner : triangle) {
        polygon.emplace_back(corner.x, corner.z);
    }
    for (const int axis : {0, 1}) {
        polygon = cut(polygon, axis, square.low[axis], 1.0F);
        polygon = cut(polygon, axis, square.high[axis], -1.0F);
    }
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i] - square.low;
        const glm::dvec2 b = polygon[(i + 1) % polygon.size()] - square.low;
        twice += a.x * b.y - a.y * b.x;
    }
    return std::fabs(twice) * 0.5;
}

/// Whether nothing ends in a square: there are level floors from edge to edge only.
bool isFlat(const TriangleSoup& soup, const std::vector<std::size_t>& triangles,
            const Square& square)
{
    std::vector<std::pair<float, double>> levels; // height, m²
    for (const std::size_t index : triangles) {
        const std::array<glm::vec3, 3> triangle{vertexOf(soup, index, 0), vertexOf(soup, index, 1),
                                                vertexOf(soup, index, 2)};
        const auto [low, high] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
        if (high - low > kFlatMetres || levels.size() > kMostFloors) {
            return false;
        }
        const double area = areaWithin(triangle, square);
        const auto same = std::ranges::find_if(levels, [&, at = low](const auto& level) {
            return std::fabs(level.first - at) <= kFlatMetres;
        });
        if (same == levels.end()) {
            levels.emplace_back(low, area);
        } else {
            same->second += area;
        }
    }
    const glm::dvec2 size = square.high - square.low;
    return std::ranges::all_of(levels, [whole = size.x * size.y](const auto& level) {
        return level.second == 0.0 ||
               std::fabs(level.second - whole) <= static_cast<double>(kWholeShare) * whole;
    });
}

bool isCrossed(const model::Place& area, const Square& square)
{
    const glm::vec2 at(area.position.x, area.position.z);
    const float nearest = glm::distance(at, glm::clamp(at, square.low, square.high));
    const glm::vec2 far = glm::max(glm::abs(at - square.low), glm::abs(at - square.high));
    return nearest <= area.radius + kBeside && glm::length(far) >= area.radius - kBeside;
}

/// Sorts the triangles by the tiles that they come to.
void share(const TriangleSoup& soup, SurfaceTiles& tiles)
{
    const auto within = [&tiles](float metres, int count) {
        return static_cast<std::size_t>(
            std::clamp(std::floor(metres / tiles.side), 0.0F, static_cast<float>(count - 1)));
    };
    for (std::size_t i = 0; i < soup.triangles.size() / 3; ++i) {
        model::Bounds of;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            of.add(vertexOf(soup, i, corner));
        }
        const glm::vec2 low = glm::vec2(of.low.x, of.low.z) - tiles.origin - kBeside;
        const glm::vec2 high = glm::vec2(of.high.x, of.high.z) - tiles.origin + kBeside;
        for (std::size_t row = within(low.y, tiles.rows); row <= within(high.y, tiles.rows);
             ++row) {
            for (std::size_t column = within(low.x, tiles.columns);
                 column <= within(high.x, tiles.columns); ++column) {
                tiles.triangles[row * static_cast<std::size_t>(tiles.columns) + column].push_back(
                    i);
            }
        }
    }
}

} // namespace

SurfaceTiles SurfaceTiles::of(const TriangleSoup& soup, const SurfacePlan& plan, float coarser)
{
    const glm::vec3 size = soup.bounds.high - soup.bounds.low;
    SurfaceTiles tiles;
    tiles.origin = {soup.bounds.low.x, soup.bounds.low.z};
    tiles.side = std::max(kTileSide, std::max(size.x, size.z) / kMostTilesASide);
    tiles.columns = std::max(1, static_cast<int>(std::ceil(size.x / tiles.side)));
    tiles.rows = std::max(1, static_cast<int>(std::ceil(size.z / tiles.side)));
    const std::size_t count =
        static_cast<std::size_t>(tiles.columns) * static_cast<std::size_t>(tiles.rows);
    tiles.triangles.resize(count);
    tiles.cells.assign(count, tiles.side / kFlatCellsASide);
    share(soup, tiles);
    std::vector<std::size_t> fine;
    for (std::size_t tile = 0; tile < count; ++tile) {
        const glm::vec2 low = tiles.low(tile);
        const Square square{low - kBeside, low + tiles.side + kBeside};
        const bool isBetween = std::ranges::any_of(
            plan.areas, [&](const model::Place& area) { return isCrossed(area, square); });
        if (isBetween || !isFlat(soup, tiles.triangles[tile], square)) {
            fine.push_back(tile);
        }
    }
    const double area = static_cast<double>(tiles.side) * static_cast<double>(tiles.side) *
                        static_cast<double>(fine.size());
    const float cell =
        coarser * std::max(kFinestCell, static_cast<float>(std::sqrt(area / kMostCells)));
    const float finest = tiles.side / std::max(1.0F, std::ceil(tiles.side / cell - 0.01F));
    for (const std::size_t tile : fine) {
        tiles.cells[tile] = std::min(tiles.cells[tile], finest);
    }
    tiles.cellHeight = std::max({0.05F, fine.empty() ? 0.0F : 0.2F * finest, size.y / kMostLevels});
    return tiles;
}

} // namespace crowd::behavior
