// SPDX-License-Identifier: MIT
#include "behavior/rules/NearCells.h"

#include <algorithm>
#include <cmath>

namespace crowd::behavior {

namespace {

constexpr float kCellMetres = 4.0F;

std::int64_t lineOf(float metres)
{
    return static_cast<std::int64_t>(std::floor(metres / kCellMetres));
}

std::uint64_t keyOf(std::int64_t column, std::int64_t row)
{
    return static_cast<std::uint64_t>(column) * 0x9E3779B97F4A7C15ULL ^
           static_cast<std::uint64_t>(row);
}

} // namespace

void NearCells::clear()
{
    m_cells.clear();
    m_people.clear();
}

void NearCells::add(std::uint32_t agent, const glm::vec3& position)
{
    const Person person{agent, {position.x, position.z}};
    m_cells[keyOf(lineOf(position.x), lineOf(position.z))].push_back(person);
    m_people.push_back(person);
}

bool NearCells::gather(const glm::vec3& position, float metres,
                       std::vector<std::uint32_t>& agents) const
{
    agents.clear();
    const double side = 2.0 * static_cast<double>(metres) / static_cast<double>(kCellMetres) + 2.0;
    if (!(side * side < static_cast<double>(m_people.size()))) {
        return false;
    }
    for (std::int64_t row = lineOf(position.z - metres); row <= lineOf(position.z + metres);
         ++row) {
        for (std::int64_t column = lineOf(position.x - metres);
             column <= lineOf(position.x + metres); ++column) {
            const auto cell = m_cells.find(keyOf(column, row));
            for (std::size_t i = 0; cell != m_cells.end() && i < cell->second.size(); ++i) {
                agents.push_back(cell->second[i].agent);
            }
        }
    }
    std::ranges::sort(agents);
    agents.erase(std::unique(agents.begin(), agents.end()), agents.end());
    return true;
}

void NearCells::look(const std::vector<Person>& people, const glm::vec2& from, std::uint32_t except,
                     Nearest& nearest)
{
    for (const Person& person : people) {
        const float x = person.at.x - from.x;
        const float z = person.at.y - from.y;
        const float away = std::sqrt(x * x + z * z);
        const bool isNearer =
            away < nearest.metres || (away == nearest.metres && person.agent < nearest.agent);
        if (isNearer && person.agent != except) {
            nearest = {away, person.agent};
        }
    }
}

/// Cell by cell outwards, in rings, as long as that asks fewer than all.
std::uint32_t NearCells::nearest(const glm::vec3& position, float metres,
                                 std::uint32_t except) const
{
    const glm::vec2 from(position.x, position.z);
    const std::int64_t column = lineOf(position.x);
    const std::int64_t row = lineOf(position.z);
    Nearest nearest{metres, kNoAgent};
    std::size_t looks = 0;
    for (std::int64_t ring = 0; static_cast<float>(ring - 1) * kCellMetres <= nearest.metres;
         ++ring) {
        for (std::int64_t z = -ring; z <= ring; ++z) {
            const bool isEdge = z == -ring || z == ring;
            for (std::int64_t x = -ring; x <= ring; x += isEdge || ring == 0 ? 1 : 2 * ring) {
                const auto cell = m_cells.find(keyOf(column + x, row + z));
                if (cell != m_cells.end()) {
                    look(cell->second, from, except, nearest);
                }
                ++looks;
            }
        }
        if (looks > m_people.size()) {
            look(m_people, from, except, nearest);
            break;
        }
    }
    return nearest.agent;
}

} // namespace crowd::behavior
