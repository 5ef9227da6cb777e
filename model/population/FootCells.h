// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

#include "model/base/Bounds.h"

namespace crowd::model {

/// Foot points in cells as wide as what counts as near, metres. The points outlive it.
class FootCells
{
public:
    FootCells(std::span<const glm::vec3> positions, float metres)
        : m_positions(positions), m_metres(metres)
    {
        for (std::uint32_t row = 0; row < positions.size(); ++row) {
            m_rows[keyOf(cellOf(positions[row]))].push_back(row);
        }
    }
    /// Only those who can be near to some rows.
    FootCells(std::span<const glm::vec3> positions, float metres,
              std::span<const std::size_t> around)
        : m_positions(positions), m_metres(metres)
    {
        Bounds box;
        for (const std::size_t row : around) {
            box.add(positions[row] - metres);
            box.add(positions[row] + metres);
        }
        for (std::uint32_t row = 0; row < positions.size(); ++row) {
            const glm::vec3& at = positions[row];
            if (glm::all(glm::lessThanEqual(box.low, at)) &&
                glm::all(glm::lessThanEqual(at, box.high))) {
                m_rows[keyOf(cellOf(at))].push_back(row);
            }
        }
    }
    /// Calls visit(row) for all that are near to a row, itself too.
    template<class Visit>
    void forEachNear(std::size_t row, const Visit& visit) const
    {
        forEachNear(m_positions[row], visit);
    }
    /// Calls visit(row) for all that are near to a point.
    template<class Visit>
    void forEachNear(const glm::vec3& point, const Visit& visit) const
    {
        const glm::ivec3 middle = cellOf(point);
        for (int i = 0; i < 27; ++i) {
            const auto cell =
                m_rows.find(keyOf(middle + glm::ivec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
            if (cell == m_rows.end()) {
                continue;
            }
            for (const std::uint32_t other : cell->second) {
                if (glm::distance(point, m_positions[other]) <= m_metres) {
                    visit(other);
                }
            }
        }
    }

private:
    [[nodiscard]] glm::ivec3 cellOf(const glm::vec3& position) const
    {
        return glm::ivec3(glm::floor(glm::clamp(position / m_metres, -1.0e6F, 1.0e6F)));
    }
    [[nodiscard]] static std::uint64_t keyOf(const glm::ivec3& cell)
    {
        const auto part = [](int value) { return static_cast<std::uint64_t>(value) + 0x100000U; };
        return part(cell.x) | part(cell.y) << 21U | part(cell.z) << 42U;
    }

    std::span<const glm::vec3> m_positions;
    float m_metres;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> m_rows;
};

} // namespace crowd::model
