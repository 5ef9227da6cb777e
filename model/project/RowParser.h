// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/Result.h"
#include "model/scene/Scene.h"

namespace crowd::model {

/// A JSON value of a table cell, without building a tree.
struct CellValue
{
    enum class Kind : std::uint8_t { Null, Unsigned, Float, Text, Other };
    Kind kind = Kind::Other;
    std::uint64_t integer = 0;
    std::string_view text; ///< digits of a Float, characters of a Text
};

/// Takes the cells of the individuals' table one after the other and fills columns.
/// Errors say what is wrong; the caller adds the row.
class RowParser
{
public:
    /// `place`: of the table in the file, for messages. It has the columns `needed`.
    RowParser(std::string place, std::vector<ColumnId> needed)
        : m_place(std::move(place)), m_needed(std::move(needed))
    {
    }

    [[nodiscard]] const std::string& place() const { return m_place; }
    /// The names in the file, first of them "id". Columns that are not known are kept as text.
    [[nodiscard]] Result<void> setColumns(const std::vector<std::string>& names);

    [[nodiscard]] std::size_t columnCount() const { return m_cells.size(); }
    [[nodiscard]] bool isKnown(std::size_t cell) const { return m_cells[cell].unknown < 0; }
    /// Does this column's value consist of three numbers?
    [[nodiscard]] bool isVector(std::size_t cell) const;
    [[nodiscard]] std::string nameOf(std::size_t cell) const;

    /// All return null when it fits, a message of what is expected otherwise.
    [[nodiscard]] const char* put(std::size_t cell, const CellValue& value);
    [[nodiscard]] const char* putComponent(std::size_t cell, std::size_t component,
                                           const CellValue& value);
    void putUnknown(std::size_t cell, std::string text);
    /// Of a table whose rows do not say it themselves: as the first cell of the next row.
    void putId(IndividualId id) { m_ids.push_back(id); }
    void endRow() { ++m_rows; }
    [[nodiscard]] std::size_t rowCount() const { return m_rows; }

    /// Sorts by id, checks ids and templates, frees seats that are taken twice (with a warning),
    /// and moves everything into the scene.
    [[nodiscard]] Result<void> finish(Scene& scene);
    /// The table as it is, sorted by id.
    struct Table
    {
        IndividualRows rows;
        std::vector<UnknownColumn> unknownColumns;
    };
    [[nodiscard]] Result<Table> take();

private:
    struct Cell
    {
        int column = -1;  ///< ColumnId, -1: the id
        int unknown = -1; ///< index into m_unknown, -1: known
    };

    [[nodiscard]] std::vector<UnknownColumn> unknownOf(std::span<const IndividualId> ids,
                                                       std::span<const std::size_t> order);
    [[nodiscard]] Result<IndividualRows> sortedRows(std::vector<std::size_t>& order);
    void putBytes(const Cell& cell, const void* value, std::size_t size);

    std::string m_place;
    std::vector<ColumnId> m_needed;
    std::vector<Cell> m_cells;
    std::vector<IndividualId> m_ids;
    std::array<std::vector<std::byte>, kColumnCount> m_bytes;
    std::vector<UnknownColumn> m_unknown;
    std::vector<std::vector<std::string>> m_unknownTexts; ///< per unknown column, one a row
    std::size_t m_rows = 0;
};

} // namespace crowd::model
