// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "model/population/Population.h"

namespace crowd::model {

/// Rows of individuals as the history keeps them: only the columns in which somebody has another
/// value than the default, and those in which all have the same only once.
struct StoredRows
{
    struct Column
    {
        ColumnId column{};
        std::vector<std::byte> bytes; ///< ids.size() × stride, or one stride
        friend bool operator==(const Column&, const Column&) = default;
    };
    std::vector<IndividualId> ids; ///< ascending
    std::vector<Column> columns;   ///< ascending

    StoredRows() = default;
    explicit StoredRows(const IndividualRows& rows);

    [[nodiscard]] IndividualRows unpacked() const;
    [[nodiscard]] std::size_t bytes() const;
    friend bool operator==(const StoredRows&, const StoredRows&) = default;
};

/// Keeps rows of bytes once where all are the same.
void keepOnceIfUniform(std::vector<std::byte>& bytes, std::size_t stride);

} // namespace crowd::model
