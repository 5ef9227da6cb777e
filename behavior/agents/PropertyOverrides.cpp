// SPDX-License-Identifier: MIT
#include "behavior/agents/PropertyOverrides.h"

#include <algorithm>
#include <cassert>

namespace crowd::behavior {

OverrideColumn presentIn(const model::Population& people, model::ColumnId column,
                         const OverrideColumn& values)
{
    const std::size_t stride = model::columnInfo(column).stride;
    OverrideColumn present;
    for (std::size_t i = 0; i < values.ids.size(); ++i) {
        if (people.rowOf(values.ids[i]) != model::Population::npos) {
            present.ids.push_back(values.ids[i]);
            const auto value = values.bytes.begin() + static_cast<std::ptrdiff_t>(i * stride);
            present.bytes.insert(present.bytes.end(), value,
                                 value + static_cast<std::ptrdiff_t>(stride));
        }
    }
    return present;
}

void PropertyOverrides::set(model::ColumnId column, model::IndividualId id,
                            std::span<const std::byte> value)
{
    assert(value.size() == model::columnInfo(column).stride && value.size() <= kWidest);
    const auto index = static_cast<std::size_t>(column);
    std::ranges::copy(value, m_values[index][id].begin());
    m_isStale.set(index);
}

bool PropertyOverrides::forget(model::ColumnId column, model::IndividualId id)
{
    const auto index = static_cast<std::size_t>(column);
    const bool isForgotten = m_values[index].erase(id) > 0;
    m_isStale.set(index, m_isStale.test(index) || isForgotten);
    return isForgotten;
}

std::shared_ptr<const OverrideColumns> PropertyOverrides::publish()
{
    if (m_isStale.none()) {
        return m_published;
    }
    auto published = m_published ? std::make_shared<OverrideColumns>(*m_published)
                                 : std::make_shared<OverrideColumns>();
    for (std::size_t index = 0; index < model::kColumnCount; ++index) {
        if (!m_isStale.test(index)) {
            continue;
        }
        const std::size_t stride = model::columnInfo(static_cast<model::ColumnId>(index)).stride;
        OverrideColumn column;
        column.ids.reserve(m_values[index].size());
        column.bytes.reserve(m_values[index].size() * stride);
        for (const auto& [id, value] : m_values[index]) {
            column.ids.push_back(id);
            column.bytes.insert(column.bytes.end(), value.begin(),
                                value.begin() + static_cast<std::ptrdiff_t>(stride));
        }
        published->put(static_cast<model::ColumnId>(index), std::move(column));
    }
    m_isStale.reset();
    m_published = std::move(published);
    return m_published;
}

} // namespace crowd::behavior
