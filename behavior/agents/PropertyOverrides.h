// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/population/Columns.h"
#include "model/population/Population.h"

namespace crowd::behavior {

/// Values of one property for those individuals who have another one than in the scene: ids
/// ascending, and so many times the property's stride of bytes.
struct OverrideColumn
{
    std::vector<model::IndividualId> ids;
    std::vector<std::byte> bytes;
};

/// The same without individuals whom a population does not have.
[[nodiscard]] OverrideColumn presentIn(const model::Population& people, model::ColumnId column,
                                       const OverrideColumn& values);

/// All properties that differ from the scene, one sparse column each, as of one step. Immutable
/// once published; may be read on any thread.
class OverrideColumns
{
public:
    /// Null: nobody's differs.
    [[nodiscard]] const OverrideColumn* column(model::ColumnId column) const
    {
        return m_columns[static_cast<std::size_t>(column)].get();
    }
    /// Before it is published. One without individuals is none.
    void put(model::ColumnId column, OverrideColumn values)
    {
        m_columns[static_cast<std::size_t>(column)] =
            values.ids.empty() ? nullptr
                               : std::make_shared<const OverrideColumn>(std::move(values));
    }
    /// The same, shared with others that have it.
    void put(model::ColumnId column, std::shared_ptr<const OverrideColumn> values)
    {
        m_columns[static_cast<std::size_t>(column)] = std::move(values);
    }
    [[nodiscard]] bool isEmpty() const
    {
        return std::ranges::none_of(m_columns, [](const auto& each) { return each != nullptr; });
    }

private:
    std::array<std::shared_ptr<const OverrideColumn>, model::kColumnCount> m_columns;
};

/// What rules have set of people's properties since the session began. Knows of a property only
/// its column: how wide a value is comes from model::columnInfo(). By individual, so that who is
/// removed and brought back by an undo has them again. One thread.
class PropertyOverrides
{
public:
    /// `value` is as long as the column's stride.
    void set(model::ColumnId column, model::IndividualId id, std::span<const std::byte> value);
    template<class T>
    void set(model::ColumnKey<T> key, model::IndividualId id, const T& value)
    {
        set(key.id, id, std::as_bytes(std::span(&value, 1)));
    }
    /// The scene's value counts again. False: it did before.
    bool forget(model::ColumnId column, model::IndividualId id);
    template<class T>
    [[nodiscard]] std::optional<T> value(model::ColumnKey<T> key, model::IndividualId id) const
    {
        const Values& values = m_values[static_cast<std::size_t>(key.id)];
        const auto found = values.find(id);
        if (found == values.end()) {
            return std::nullopt;
        }
        T value;
        std::memcpy(&value, found->second.data(), sizeof(T));
        return value;
    }
    /// As they are now; columns that nobody wrote since the last call are shared with that. Null
    /// before anything was set.
    [[nodiscard]] std::shared_ptr<const OverrideColumns> publish();

private:
    static constexpr std::size_t kWidest = 16; ///< bytes of a value
    using Values = std::map<model::IndividualId, std::array<std::byte, kWidest>>;

    std::array<Values, model::kColumnCount> m_values;
    std::bitset<model::kColumnCount> m_isStale;
    std::shared_ptr<const OverrideColumns> m_published;
};

} // namespace crowd::behavior
