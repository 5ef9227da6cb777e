// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <iterator>
#include <span>
#include <vector>

#include "model/brush/PropertyChange.h"

namespace crowd::model {

/// Gives these people, ascending ids, one value each.
using WriteColumn = std::function<void(ColumnId column, std::span<const IndividualId> ids,
                                       std::span<const std::byte> bytes)>;

/// Values of one column as bytes, of whatever type it is: those that differ from today's, in
/// ascending order of id.
class ByteChange
{
public:
    ByteChange(const Population& people, ColumnId column)
        : m_column(column), m_stride(columnInfo(column).stride), m_now(people.columnBytes(column))
    {
    }
    [[nodiscard]] std::span<const std::byte> of(std::size_t row) const
    {
        return m_now.subspan(row * m_stride, m_stride);
    }
    /// `value`: one of the column's.
    void set(IndividualId id, std::size_t row, std::span<const std::byte> value)
    {
        if (std::memcmp(of(row).data(), value.data(), m_stride) != 0) {
            m_ids.push_back(id);
            m_values.insert(m_values.end(), value.begin(), value.end());
        }
    }
    /// Adds those who changed to `changed`.
    void apply(SceneEdit& edit, std::vector<IndividualId>& changed) const
    {
        apply([&edit](auto... what) { edit.setColumn(what...); }, changed);
    }
    void apply(const WriteColumn& write, std::vector<IndividualId>& changed) const
    {
        write(m_column, m_ids, m_values);
        if (m_ids.empty() || changed == m_ids) {
            return;
        }
        if (changed.empty()) {
            changed = m_ids;
            return;
        }
        std::vector<IndividualId> all;
        std::ranges::set_union(changed, m_ids, std::back_inserter(all));
        changed = std::move(all);
    }

private:
    ColumnId m_column;
    std::size_t m_stride;
    std::span<const std::byte> m_now;
    std::vector<IndividualId> m_ids;
    std::vector<std::byte> m_values;
};

/// By slot.
inline constexpr std::array kTintColumns{ColumnId::Tint0, ColumnId::Tint1, ColumnId::Tint2,
                                         ColumnId::Tint3, ColumnId::Tint4, ColumnId::Tint5,
                                         ColumnId::Tint6, ColumnId::Tint7};

} // namespace crowd::model
