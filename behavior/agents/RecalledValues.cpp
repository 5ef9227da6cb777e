// SPDX-License-Identifier: MIT
#include "behavior/agents/RecalledValues.h"

#include <cstring>

#include "model/population/Properties.h"

namespace crowd::behavior {

using namespace model;

namespace {

std::span<const std::byte> valueAt(const Population& people, ColumnId column, std::size_t row)
{
    const std::size_t stride = columnInfo(column).stride;
    return people.columnBytes(column).subspan(row * stride, stride);
}

bool isSame(std::span<const std::byte> a, std::span<const std::byte> b)
{
    return std::memcmp(a.data(), b.data(), a.size()) == 0;
}

void add(OverrideColumn& column, IndividualId id, std::span<const std::byte> value)
{
    column.ids.push_back(id);
    column.bytes.insert(column.bytes.end(), value.begin(), value.end());
}

/// Those in whom the two differ; the same people.
OverrideColumn differenceOf(const Population& scene, const Population& now, ColumnId column)
{
    OverrideColumn values;
    if (scene.columnBytes(column).data() == now.columnBytes(column).data()) {
        return values; // shared: nobody wrote
    }
    for (std::size_t row = 0; row < now.size(); ++row) {
        const auto value = valueAt(now, column, row);
        if (!isSame(value, valueAt(scene, column, row))) {
            add(values, now.ids()[row], value);
        }
    }
    return values;
}

/// Without those to whom an edit has given another value.
OverrideColumn unedited(const OverrideColumn& values, const Population& before,
                        const Population& now, ColumnId column)
{
    const std::size_t stride = columnInfo(column).stride;
    OverrideColumn left;
    for (std::size_t i = 0; i < values.ids.size(); ++i) {
        const std::size_t then = before.rowOf(values.ids[i]);
        const std::size_t row = now.rowOf(values.ids[i]);
        if (then != Population::npos && row != Population::npos &&
            isSame(valueAt(before, column, then), valueAt(now, column, row))) {
            add(left, values.ids[i], std::span(values.bytes).subspan(i * stride, stride));
        }
    }
    return left;
}

} // namespace

Population RecalledValues::over(const Population& scene) const
{
    Population people = scene;
    if (m_columns) {
        writeColumns(*m_columns, people);
    }
    return people;
}

void RecalledValues::take(const Population& scene, const Population& now, ColumnSet columns)
{
    OverrideColumns taken = m_columns ? *m_columns : OverrideColumns();
    columns.forEach([&](ColumnId column) { taken.put(column, differenceOf(scene, now, column)); });
    put(std::move(taken));
}

void RecalledValues::forgetEdited(const Population& before, const Population& now)
{
    if (!m_columns) {
        return;
    }
    OverrideColumns left = *m_columns;
    for (const PropertyInfo& property : properties()) {
        const OverrideColumn* values = m_columns->column(property.id);
        const bool isWritten =
            before.columnBytes(property.id).data() != now.columnBytes(property.id).data();
        if (values != nullptr && isWritten) {
            left.put(property.id, unedited(*values, before, now, property.id));
        }
    }
    put(std::move(left));
}

void RecalledValues::put(OverrideColumns columns)
{
    m_columns =
        columns.isEmpty() ? nullptr : std::make_shared<const OverrideColumns>(std::move(columns));
}

void writeColumns(const OverrideColumns& columns, Population& people)
{
    for (const PropertyInfo& property : properties()) {
        if (const OverrideColumn* values = columns.column(property.id)) {
            const OverrideColumn there = presentIn(people, property.id, *values);
            if (!there.ids.empty()) {
                people.setValues(property.id, there.ids, there.bytes);
            }
        }
    }
}

} // namespace crowd::behavior
