// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "model/population/Properties.h"

/// Values of any property, as its column stores them: whole rows of bytes.
namespace crowd::model {

/// Floats of one value; 0 where it is made of something else.
[[nodiscard]] std::size_t floatsPerValue(ColumnType type);
/// One number that double holds exactly.
[[nodiscard]] bool isScalar(ColumnType type);
/// Of a scalar: the value in a row of the column.
[[nodiscard]] double scalarAt(ColumnType type, std::span<const std::byte> column, std::size_t row);
/// One row of a scalar column. The number is one that its type has.
[[nodiscard]] std::vector<std::byte> scalarBytes(ColumnType type, double value);

/// Whether two values, one row each, are equal: numbers by value, all else by its bytes.
[[nodiscard]] bool isSameValue(ColumnType type, std::span<const std::byte> a,
                               std::span<const std::byte> b);

/// The nearest legal number of a floating-point property.
[[nodiscard]] float nearestLegal(const PropertyInfo& property, float value);
/// A component outside its legal range, or one that is not a number.
struct IllegalNumber
{
    std::size_t row = 0;
    float value = 0.0F;
};
[[nodiscard]] std::optional<IllegalNumber> firstIllegal(const PropertyInfo& property,
                                                        std::span<const std::byte> column);
/// How many rows have one.
[[nodiscard]] std::size_t countIllegal(const PropertyInfo& property,
                                       std::span<const std::byte> column);

} // namespace crowd::model
