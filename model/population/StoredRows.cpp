// SPDX-License-Identifier: MIT
#include "model/population/StoredRows.h"

#include <algorithm>
#include <cstring>

#include "model/population/Properties.h"

namespace crowd::model {

StoredRows::StoredRows(const IndividualRows& rows) : ids(rows.ids)
{
    for (const PropertyInfo& property : properties()) {
        const std::size_t stride = property.column.stride;
        Column stored{property.id, rows.bytes[static_cast<std::size_t>(property.id)]};
        keepOnceIfUniform(stored.bytes, stride);
        const bool isDefault =
            stored.bytes.empty() ||
            (stored.bytes.size() == stride &&
             std::memcmp(stored.bytes.data(), property.initial.data(), stride) == 0);
        if (!isDefault) {
            columns.push_back(std::move(stored));
        }
    }
}

IndividualRows StoredRows::unpacked() const
{
    IndividualRows rows = IndividualRows::withDefaults(ids);
    for (const Column& stored : columns) {
        const std::size_t stride = columnInfo(stored.column).stride;
        std::vector<std::byte>& target = rows.bytes[static_cast<std::size_t>(stored.column)];
        if (stored.bytes.size() == target.size()) {
            target = stored.bytes;
            continue;
        }
        for (std::size_t i = 0; i < ids.size(); ++i) {
            std::memcpy(&target[i * stride], stored.bytes.data(), stride);
        }
    }
    return rows;
}

std::size_t StoredRows::bytes() const
{
    std::size_t total = ids.size() * sizeof(IndividualId);
    for (const Column& stored : columns) {
        total += sizeof(Column) + stored.bytes.size();
    }
    return total;
}

void keepOnceIfUniform(std::vector<std::byte>& bytes, std::size_t stride)
{
    for (std::size_t i = stride; i < bytes.size(); i += stride) {
        if (std::memcmp(bytes.data(), &bytes[i], stride) != 0) {
            return;
        }
    }
    bytes.resize(std::min(bytes.size(), stride));
    bytes.shrink_to_fit();
}

} // namespace crowd::model
