// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/population/Columns.h"
#include "model/population/SharedVector.h"

namespace crowd::model {

/// All values of some rows, column by column, in the order of `ids` (ascending). What an added or
/// a removed individual consists of; undo keeps these.
struct IndividualRows
{
    std::vector<IndividualId> ids;
    std::array<std::vector<std::byte>, kColumnCount> bytes; ///< ids.size() × stride each

    /// n rows of default values with the given ascending ids.
    [[nodiscard]] static IndividualRows withDefaults(std::vector<IndividualId> rowIds);

    template<class T>
    [[nodiscard]] std::span<T> column(ColumnKey<T> key)
    {
        return {reinterpret_cast<T*>(bytes[static_cast<std::size_t>(key.id)].data()), ids.size()};
    }
    template<class T>
    [[nodiscard]] std::span<const T> column(ColumnKey<T> key) const
    {
        return {reinterpret_cast<const T*>(bytes[static_cast<std::size_t>(key.id)].data()),
                ids.size()};
    }
};

/// All individuals, stored column by column, rows in ascending order of id.
/// Copying is cheap (columns are shared until one side writes), so a copy is the snapshot that a
/// CrowdFrame carries; a copy may be read on any thread while the original is edited on its own.
/// Versions: every write stamps the touched blocks of kBlockRows rows with a new number that is
/// unique in the process; a reader that remembers the number it last saw uploads only newer blocks.
class Population
{
public:
    static constexpr std::size_t kBlockRows = 256;

    Population();

    [[nodiscard]] std::size_t size() const { return m_ids->size(); }
    [[nodiscard]] bool isEmpty() const { return m_ids->empty(); }
    [[nodiscard]] std::span<const IndividualId> ids() const { return *m_ids; }
    /// Row of an id, or npos.
    [[nodiscard]] std::size_t rowOf(IndividualId id) const;
    static constexpr std::size_t npos = static_cast<std::size_t>(-1);

    template<class T>
    [[nodiscard]] std::span<const T> column(ColumnKey<T> key) const
    {
        return {reinterpret_cast<const T*>(columnBytes(key.id).data()), size()};
    }
    /// size() × stride bytes.
    [[nodiscard]] std::span<const std::byte> columnBytes(ColumnId column) const;

    /// Inserts rows; their ids are ascending and none is present.
    void add(const IndividualRows& rows);
    /// Removes the rows of ascending ids, all present, and returns them.
    IndividualRows remove(std::span<const IndividualId> ids);
    /// Copies of the rows of ascending ids, all present.
    [[nodiscard]] IndividualRows rows(std::span<const IndividualId> ids) const;
    /// Values of one column for ascending ids, all present: ids.size() × stride bytes.
    [[nodiscard]] std::vector<std::byte> values(ColumnId column,
                                                std::span<const IndividualId> ids) const;
    /// Writes one column for ascending ids, all present. `bytes` holds ids.size() × stride, or one
    /// stride that all of them get.
    void setValues(ColumnId column, std::span<const IndividualId> ids,
                   std::span<const std::byte> bytes);
    template<class T>
    void setValues(ColumnKey<T> key, std::span<const IndividualId> ids, std::span<const T> items)
    {
        setValues(key.id, ids, std::as_bytes(items));
    }

    /// One column, to be written at these rows only; those beyond the end are passed over.
    template<class T>
    [[nodiscard]] std::span<T> edit(ColumnKey<T> key, std::span<const std::uint32_t> rows)
    {
        stampRows(rows);
        return {reinterpret_cast<T*>(writable(key.id).data()), size()};
    }

    /// One column, to be written at all rows.
    template<class T>
    [[nodiscard]] std::span<T> edit(ColumnKey<T> key)
    {
        stampBlocks();
        return {reinterpret_cast<T*>(writable(key.id).data()), size()};
    }

    /// Newest stamp of all.
    [[nodiscard]] std::uint64_t version() const { return m_version; }
    /// Stamp of the last add or remove: rows may have moved since an older number.
    [[nodiscard]] std::uint64_t rowsVersion() const { return m_rowsVersion; }
    /// One stamp per block of kBlockRows rows.
    [[nodiscard]] std::span<const std::uint64_t> blockVersions() const { return *m_blockVersions; }

    /// The same ids and the same bytes in every column.
    friend bool operator==(const Population& a, const Population& b);

private:
    [[nodiscard]] std::vector<std::size_t> rowsOf(std::span<const IndividualId> ids) const;
    /// add() for ids behind all present: what creating people does. Copies nothing that is not
    /// shared.
    void append(const IndividualRows& rows);
    [[nodiscard]] std::vector<std::byte>& writable(ColumnId column);
    template<class Row>
    void stampRows(std::span<const Row> rows);
    void stampBlocks();
    void stampFrom(std::size_t row);

    SharedVector<IndividualId> m_ids;
    std::array<SharedVector<std::byte>, kColumnCount> m_columns;
    SharedVector<std::uint64_t> m_blockVersions;
    std::uint64_t m_version = 0;
    std::uint64_t m_rowsVersion = 0;
};

/// Ids of those whose column has a value, ascending.
template<class T>
[[nodiscard]] std::vector<IndividualId> peopleWith(const Population& people, ColumnKey<T> key,
                                                   const T& value)
{
    const auto column = people.column(key);
    std::vector<IndividualId> ids;
    for (std::size_t row = 0; row < people.size(); ++row) {
        if (column[row] == value) {
            ids.push_back(people.ids()[row]);
        }
    }
    return ids;
}

} // namespace crowd::model
