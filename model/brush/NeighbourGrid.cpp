// SPDX-License-Identifier: MIT
#include "model/brush/NeighbourGrid.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/base/Random.h"

namespace crowd::model {

namespace {

constexpr float kSmallestCell = 0.05F;
/// Two spots at exactly the distance do not disturb each other, whatever rounding says.
constexpr float kTolerance = 1.0e-4F;

} // namespace

NeighbourGrid::NeighbourGrid(std::span<const glm::vec3> points, float distance)
    : m_distance(distance), m_cell(std::max(distance, kSmallestCell)),
      m_heads(std::bit_ceil(2 * points.size() + 64), -1)
{
    m_points.reserve(points.size());
    m_next.reserve(points.size());
    for (const glm::vec3& point : points) {
        add(point);
    }
}

std::int64_t NeighbourGrid::cellOf(float metres) const
{
    const double cell = std::floor(static_cast<double>(metres) / m_cell);
    return std::isfinite(cell) ? static_cast<std::int64_t>(cell) : 0;
}

std::size_t NeighbourGrid::bucketOf(std::int64_t x, std::int64_t z) const
{
    return static_cast<std::size_t>(hashKeys(x, z)) & (m_heads.size() - 1);
}

bool NeighbourGrid::isFree(const glm::vec3& point) const
{
    if (m_distance <= 0.0F) {
        return true;
    }
    const float limit = std::max(0.0F, m_distance - kTolerance);
    const std::int64_t cellX = cellOf(point.x);
    const std::int64_t cellZ = cellOf(point.z);
    for (std::int64_t z = cellZ - 1; z <= cellZ + 1; ++z) {
        for (std::int64_t x = cellX - 1; x <= cellX + 1; ++x) {
            for (std::int32_t i = m_heads[bucketOf(x, z)]; i >= 0;
                 i = m_next[static_cast<std::size_t>(i)]) {
                const glm::vec3 way = m_points[static_cast<std::size_t>(i)] - point;
                if (glm::dot(way, way) < limit * limit) {
                    return false;
                }
            }
        }
    }
    return true;
}

void NeighbourGrid::add(const glm::vec3& point)
{
    if (m_points.size() * 2 >= m_heads.size()) {
        grow();
    }
    std::int32_t& head = m_heads[bucketOf(cellOf(point.x), cellOf(point.z))];
    m_next.push_back(head);
    head = static_cast<std::int32_t>(m_points.size());
    m_points.push_back(point);
}

void NeighbourGrid::grow()
{
    const std::vector<glm::vec3> points = std::move(m_points);
    m_points.clear();
    m_next.clear();
    m_heads.assign(m_heads.size() * 2, -1);
    for (const glm::vec3& point : points) {
        add(point);
    }
}

void NeighbourGrid::truncate(std::size_t count)
{
    while (m_points.size() > count) {
        // The newest point is the head of its bucket.
        const glm::vec3& last = m_points.back();
        m_heads[bucketOf(cellOf(last.x), cellOf(last.z))] = m_next.back();
        m_points.pop_back();
        m_next.pop_back();
    }
}

} // namespace crowd::model
