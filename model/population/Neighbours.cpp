// SPDX-License-Identifier: MIT
#include "model/population/Neighbours.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string>

#include "model/population/FootCells.h"

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
