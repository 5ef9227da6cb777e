// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>
#include <cstddef>
#include <initializer_list>

#include "model/population/Columns.h"

namespace crowd::model {

/// A set of the first Count columns; there may be more of them than a machine word has bits.
template<std::size_t Count>
class ColumnBits
{
public:
    ColumnBits() = default;
    ColumnBits(std::initializer_list<ColumnId> columns)
    {
        for (const ColumnId column : columns) {
            insert(column);
        }
    }

    void insert(ColumnId column) { m_bits.set(static_cast<std::size_t>(column)); }
    [[nodiscard]] bool contains(ColumnId column) const
    {
        return m_bits.test(static_cast<std::size_t>(column));
    }
    [[nodiscard]] bool isEmpty() const { return m_bits.none(); }
    /// Calls visit(ColumnId) for each, in ascending order.
    template<class Visit>
    void forEach(const Visit& visit) const
    {
        for (std::size_t column = 0; column < Count; ++column) {
            if (m_bits.test(column)) {
                visit(static_cast<ColumnId>(column));
            }
        }
    }
    friend bool operator==(const ColumnBits&, const ColumnBits&) = default;

private:
    std::bitset<Count> m_bits;
};

using ColumnSet = ColumnBits<kColumnCount>;

} // namespace crowd::model
