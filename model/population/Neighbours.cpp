// SPDX-License-Identifier: MIT
#include "model/population/Neighbours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <unordered_map>

#include <glm/geometric.hpp>

namespace crowd::model {

namespace {

constexpr std::array kLooks{ColumnId::Template,        ColumnId::Tint0, ColumnId::Tint1,
                            ColumnId::Tint2,           ColumnId::Tint3, ColumnId::Tint4,
                            ColumnId::Tint5,           ColumnId::Tint6, ColumnId::Tint7,
                            ColumnId::MaterialChoices, ColumnId::Parts, ColumnId::TintReplaces};

/// The bytes of all columns that somebody's looks are chosen by.
std::string looksOf(const Population& people, std::size_t row)
{
    std::string looks;
    for (const ColumnId column : kLooks) {
        const std::size_t stride = columnInfo(column).stride;
        const auto bytes = people.columnBytes(column).subspan(row * stride, stride);
        looks.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }
    return looks;
}

/// Foot points in cells as wide as what counts as near.
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
    /// Calls visit(row) for all that are near to a row, itself too.
    template<class Visit>
    void forEachNear(std::size_t row, const Visit& visit) const
    {
        const glm::ivec3 middle = cellOf(m_positions[row]);
        for (int i = 0; i < 27; ++i) {
            const auto cell =
                m_rows.find(keyOf(middle + glm::ivec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
            if (cell == m_rows.end()) {
                continue;
            }
            for (const std::uint32_t other : cell->second) {
                if (glm::distance(m_positions[row], m_positions[other]) <= m_metres) {
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

std::vector<char> rowsOf(const Population& people, std::span<const IndividualId> ids)
{
    std::vector<char> isIn(people.size(), 0);
    for (const IndividualId id : ids) {
        isIn[people.rowOf(id)] = 1;
    }
    return isIn;
}

std::vector<IndividualId> idsOf(const Population& people, const std::vector<char>& isIn)
{
    std::vector<IndividualId> ids;
    for (std::size_t row = 0; row < isIn.size(); ++row) {
        if (isIn[row] != 0) {
            ids.push_back(people.ids()[row]);
        }
    }
    return ids;
}

} // namespace

std::vector<IndividualId> lookAlikes(const Population& people, std::span<const IndividualId> ids)
{
    std::set<std::string> wanted;
    for (const IndividualId id : ids) {
        wanted.insert(looksOf(people, people.rowOf(id)));
    }
    std::vector<IndividualId> alike;
    for (std::size_t row = 0; row < people.size(); ++row) {
        if (wanted.contains(looksOf(people, row))) {
            alike.push_back(people.ids()[row]);
        }
    }
    return alike;
}

std::vector<IndividualId> withNeighbours(const Population& people,
                                         std::span<const IndividualId> ids, float metres)
{
    const FootCells cells(people.column(columns::position), metres);
    std::vector<char> isIn = rowsOf(people, ids);
    for (const IndividualId id : ids) {
        cells.forEachNear(people.rowOf(id), [&isIn](std::uint32_t row) { isIn[row] = 1; });
    }
    return idsOf(people, isIn);
}

std::vector<IndividualId> withoutRim(const Population& people, std::span<const IndividualId> ids,
                                     float metres)
{
    const FootCells cells(people.column(columns::position), metres);
    const std::vector<char> wasIn = rowsOf(people, ids);
    std::vector<char> isIn = wasIn;
    for (const IndividualId id : ids) {
        const std::size_t row = people.rowOf(id);
        cells.forEachNear(row, [&](std::uint32_t other) {
            if (wasIn[other] == 0) {
                isIn[row] = 0;
            }
        });
    }
    return idsOf(people, isIn);
}

} // namespace crowd::model
