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
constexpr double kMostCellsAside = 100.0; ///< looked at to each side
/// Two spots at exactly the distance do not disturb each other, whatever rounding says.
constexpr float kTolerance = 1.0e-4F;

} // namespace

NeighbourGrid::NeighbourGrid(std::span<const GroundDisc> discs, float distance)
    : m_distance(distance), m_cell(std::max(distance, kSmallestCell)),
      m_heads(std::bit_ceil(2 * discs.size() + 64), -1)
{
    m_discs.reserve(discs.size());
    m_next.reserve(discs.size());
    for (const GroundDisc& disc : discs) {
        add(disc);
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

bool NeighbourGrid::isFree(const GroundDisc& disc) const
{
    if (m_distance <= 0.0F) {
        return true;
    }
    const float reach = m_distance + m_widest + disc.wider;
    const auto cells = static_cast<std::int64_t>(
        std::ceil(std::min(static_cast<double>(reach) / m_cell, kMostCellsAside)));
    const std::int64_t cellX = cellOf(disc.at.x);
    const std::int64_t cellZ = cellOf(disc.at.z);
    for (std::int64_t z = cellZ - cells; z <= cellZ + cells; ++z) {
        for (std::int64_t x = cellX - cells; x <= cellX + cells; ++x) {
            for (std::int32_t i = m_heads[bucketOf(x, z)]; i >= 0;
                 i = m_next[static_cast<std::size_t>(i)]) {
                const GroundDisc& other = m_discs[static_cast<std::size_t>(i)];
                const glm::vec3 way = other.at - disc.at;
                const float limit =
                    std::max(0.0F, m_distance + disc.wider + other.wider - kTolerance);
                if (glm::dot(way, way) < limit * limit) {
                    return false;
                }
            }
        }
    }
    return true;
}

void NeighbourGrid::add(const GroundDisc& disc)
{
    if (m_discs.size() * 2 >= m_heads.size()) {
        grow();
    }
    std::int32_t& head = m_heads[bucketOf(cellOf(disc.at.x), cellOf(disc.at.z))];
    m_next.push_back(head);
    head = static_cast<std::int32_t>(m_discs.size());
    m_discs.push_back(disc);
    m_widest = std::max(m_widest, disc.wider);
}

void NeighbourGrid::grow()
{
    const std::vector<GroundDisc> discs = std::move(m_discs);
    m_discs.clear();
    m_next.clear();
    m_heads.assign(m_heads.size() * 2, -1);
    for (const GroundDisc& disc : discs) {
        add(disc);
    }
}

void NeighbourGrid::truncate(std::size_t count)
{
    while (m_discs.size() > count) {
        // The newest disc is the head of its bucket.
        const glm::vec3& last = m_discs.back().at;
        m_heads[bucketOf(cellOf(last.x), cellOf(last.z))] = m_next.back();
        m_discs.pop_back();
        m_next.pop_back();
    }
}

} // namespace crowd::model
