// SPDX-License-Identifier: MIT
#include "widgets/viewport/GroundSheets.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace crowd::widgets {

namespace {

constexpr float kLift = 0.03F;     ///< metres above the ground
constexpr float kFlatness = 0.02F; ///< metres off that do not matter
constexpr float kHeadroom = 0.7F;  ///< metres; what has less above it is inside something
constexpr float kDropMetres = 0.8F;
constexpr float kDropSlope = 0.35F; ///< cosine
constexpr float kLeastRow = 0.1F;   ///< metres; rows are not halved below
constexpr int kMostRows = 400;      ///< before halving
constexpr int kMostColumns = 8;
constexpr float kPlaceReach = 3.0F; ///< metres up and down from a place
constexpr float kMostReach = 8.0F;
constexpr float kAsideReach = 1.0F; ///< ... from the middle of a band, at its middle
constexpr float kAsideSlope = 0.5F; ///< ... and so much more a metre aside

/// A row of points across a sheet, at a share of its length.
struct Row
{
    float share = 0.0F;
    std::vector<glm::vec3> points;
};
using RowAt = std::function<Row(float share)>;

/// Whether the points of a row lie on the straight lines between two others.
bool isBetween(const Row& row, const Row& low, const Row& high)
{
    const float share = (row.share - low.share) / (high.share - low.share);
    for (std::size_t i = 0; i < row.points.size(); ++i) {
        const glm::vec3 line = glm::mix(low.points[i], high.points[i], share);
        if (glm::distance(row.points[i], line) > kFlatness) {
            return false;
        }
    }
    return true;
}

bool isStraight(const Row& row)
{
    const auto count = static_cast<float>(row.points.size() - 1);
    for (std::size_t i = 1; i + 1 < row.points.size(); ++i) {
        const glm::vec3 line =
            glm::mix(row.points.front(), row.points.back(), static_cast<float>(i) / count);
        if (glm::distance(row.points[i], line) > kFlatness) {
            return false;
        }
    }
    return true;
}

/// Appends the rows between two, and the second.
void addRows(const RowAt& rowAt, const Row& low, const Row& high, float metres,
             std::vector<Row>& rows)
{
    if (metres > kLeastRow) {
        const Row middle = rowAt((low.share + high.share) * 0.5F);
        if (!isBetween(middle, low, high)) {
            addRows(rowAt, low, middle, metres * 0.5F, rows);
            addRows(rowAt, middle, high, metres * 0.5F, rows);
            return;
        }
    }
    rows.push_back(high);
}

/// Without rows that change nothing.
std::vector<Row> merged(const std::vector<Row>& rows)
{
    std::vector<Row> kept{rows.front()};
    std::size_t last = 0;
    for (std::size_t next = 2; next < rows.size(); ++next) {
        bool isFlat = true;
        for (std::size_t i = last + 1; i < next && isFlat; ++i) {
            isFlat = isBetween(rows[i], rows[last], rows[next]);
        }
        if (!isFlat) {
            last = next - 1;
            kept.push_back(rows[last]);
        }
    }
    kept.push_back(rows.back());
    return kept;
}

/// From one floor to another: nothing that a shape lies on.
bool isDrop(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    const float rise = std::max({a.y, b.y, c.y}) - std::min({a.y, b.y, c.y});
    const glm::vec3 normal = glm::cross(b - a, c - a);
    return rise > kDropMetres && std::abs(normal.y) < kDropSlope * glm::length(normal);
}

std::vector<GroundTriangle> triangles(const std::vector<Row>& rows)
{
    std::vector<GroundTriangle> out;
    const auto add = [&out](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        if (a != b && b != c && a != c && !isDrop(a, b, c)) {
            out.push_back({a, b, c});
        }
    };
    for (std::size_t r = 0; r + 1 < rows.size(); ++r) {
        const auto& low = rows[r].points;
        const auto& high = rows[r + 1].points;
        const std::size_t last = low.size() - 1;
        const std::size_t step = isStraight(rows[r]) && isStraight(rows[r + 1]) ? last : 1;
        for (std::size_t i = 0; i < last; i += step) {
            add(low[i], low[i + step], high[i + step]);
            add(low[i], high[i + step], high[i]);
        }
    }
    return out;
}

std::vector<Row> rowsOf(const RowAt& rowAt, float metres, int count)
{
    std::vector<Row> rows{rowAt(0.0F)};
    for (int i = 1; i <= count; ++i) {
        const Row low = rows.back();
        addRows(rowAt, low, rowAt(static_cast<float>(i) / static_cast<float>(count)),
                metres / static_cast<float>(count), rows);
    }
    return rows;
}

int cells(float metres, float cell, int least, int most)
{
    const float count = std::ceil(metres / cell);
    return count < static_cast<float>(most) ? std::max(least, static_cast<int>(count)) : most;
}

} // namespace

void GroundSheets::begin(const model::StageRays& rays, float cell)
{
    m_before = std::move(m_sheets);
    m_sheets.clear();
    if (m_rays != &rays || m_version != rays.version() || m_cell != cell) {
        m_before.clear();
    }
    m_rays = &rays;
    m_version = rays.version();
    m_cell = cell;
}

const std::vector<GroundTriangle>* GroundSheets::remembered(const Key& key)
{
    if (const auto now = m_sheets.find(key); now != m_sheets.end()) {
        return &now->second;
    }
    if (auto before = m_before.extract(key)) {
        return &m_sheets.insert(std::move(before)).position->second;
    }
    return nullptr;
}

glm::vec3 GroundSheets::onGround(const glm::vec3& point, float reach) const
{
    float best = reach;
    float height = point.y;
    float above = std::numeric_limits<float>::infinity();
    const glm::vec3 start = point + glm::vec3(0.0F, reach + kHeadroom, 0.0F);
    for (const model::SurfaceHit& hit : m_rays->below(start)) {
        const bool isBuried = above - hit.point.y < kHeadroom;
        above = hit.point.y;
        const float off = std::abs(hit.point.y - point.y);
        if (!isBuried && off <= best) {
            best = off;
            height = hit.point.y;
        }
    }
    return {point.x, height + kLift, point.z};
}

float GroundSheets::reachBetween(float metres, float share)
{
    constexpr float kSlope = 0.35F;
    return std::min(kMostReach, kPlaceReach + kSlope * metres * std::min(share, 1.0F - share));
}

const std::vector<GroundTriangle>& GroundSheets::band(const BandShape& shape)
{
    const Key key{
        shape.from.x, shape.from.y,      shape.from.z,      shape.to.x,      shape.to.y,
        shape.to.z,   shape.fromAside.x, shape.fromAside.y, shape.toAside.x, shape.toAside.y,
        -1.0F};
    if (const auto* known = remembered(key)) {
        return *known;
    }
    const glm::vec2 way(shape.to.x - shape.from.x, shape.to.z - shape.from.z);
    const float metres = glm::length(way);
    std::vector<GroundTriangle>& made = m_sheets[key];
    if (!(metres > 0.0F)) {
        return made;
    }
    const glm::vec3 aside(way.y / metres, 0.0F, -way.x / metres);
    const float widest =
        std::max(shape.fromAside.y - shape.fromAside.x, shape.toAside.y - shape.toAside.x);
    const int columns = cells(widest, m_cell, 1, kMostColumns);
    const auto rowAt = [&](float share) {
        const glm::vec3 line = glm::mix(shape.from, shape.to, share);
        const glm::vec3 middle = onGround(line, reachBetween(metres, share));
        const glm::vec2 borders = glm::mix(shape.fromAside, shape.toAside, share);
        Row row{share, {}};
        for (int i = 0; i <= columns; ++i) {
            const float part = static_cast<float>(i) / static_cast<float>(columns);
            const float off = glm::mix(borders.x, borders.y, part);
            row.points.push_back(
                onGround({line.x + aside.x * off, middle.y - kLift, line.z + aside.z * off},
                         kAsideReach + kAsideSlope * std::abs(off)));
        }
        return row;
    };
    made = triangles(merged(rowsOf(rowAt, metres, cells(metres, m_cell, 1, kMostRows))));
    return made;
}

const std::vector<GroundTriangle>& GroundSheets::ring(const RingShape& shape)
{
    const Key key{shape.center.x, shape.center.y, shape.center.z, shape.inner, shape.outer, 0.0F,
                  0.0F,           0.0F,           0.0F,           0.0F,        1.0F};
    if (const auto* known = remembered(key)) {
        return *known;
    }
    constexpr int kLeastSides = 48;
    constexpr float kTurn = 2.0F * std::numbers::pi_v<float>;
    const float metres = kTurn * shape.outer;
    const int columns = cells(shape.outer - shape.inner, m_cell, 1, kMostColumns);
    const float middle = onGround(shape.center, kPlaceReach).y - kLift;
    const auto rowAt = [&](float share) {
        const float angle = kTurn * share;
        const glm::vec3 out(std::sin(angle), 0.0F, std::cos(angle));
        Row row{share, {}};
        for (int i = 0; i <= columns; ++i) {
            const float part = static_cast<float>(i) / static_cast<float>(columns);
            const float radius = glm::mix(shape.inner, shape.outer, part);
            row.points.push_back(
                onGround({shape.center.x + out.x * radius, middle, shape.center.z + out.z * radius},
                         kAsideReach + kAsideSlope * radius));
        }
        return row;
    };
    std::vector<GroundTriangle>& made = m_sheets[key];
    made = triangles(rowsOf(rowAt, metres, cells(metres, m_cell, kLeastSides, kMostRows)));
    return made;
}

} // namespace crowd::widgets
