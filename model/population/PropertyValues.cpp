// SPDX-License-Identifier: MIT
#include "model/population/PropertyValues.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace crowd::model {

namespace {

/// In the precision of the values: 0.01 as a float lies below 0.01.
struct FloatRange
{
    float low;
    float high;

    explicit FloatRange(const FieldMeta& meta)
        : low(static_cast<float>(meta.low)), high(static_cast<float>(meta.high))
    {
    }
    [[nodiscard]] bool contains(float value) const // false where it is not a number
    {
        return value >= low && value <= high;
    }
};

std::span<const float> floatsOf(ColumnType type, std::span<const std::byte> column)
{
    if (floatsPerValue(type) == 0) {
        return {};
    }
    return {reinterpret_cast<const float*>(column.data()), column.size() / sizeof(float)};
}

/// No branch for each number: whole columns are checked on their way in.
bool areAllWithin(const FloatRange& range, std::span<const float> numbers)
{
    bool areRight = true;
    for (const float each : numbers) {
        areRight &= static_cast<bool>(static_cast<int>(each >= range.low) &
                                      static_cast<int>(each <= range.high));
    }
    return areRight;
}

template<class T>
double numberAt(std::span<const std::byte> column, std::size_t row)
{
    T value{};
    std::memcpy(&value, &column[row * sizeof(T)], sizeof(T));
    return static_cast<double>(value);
}

template<class T>
std::vector<std::byte> bytesOf(double value)
{
    const T item = static_cast<T>(value);
    std::vector<std::byte> bytes(sizeof(T));
    std::memcpy(bytes.data(), &item, sizeof(T));
    return bytes;
}

} // namespace

std::size_t floatsPerValue(ColumnType type)
{
    return type == ColumnType::Float ? 1 : type == ColumnType::Vec3 ? 3 : 0;
}

bool isScalar(ColumnType type)
{
    return type == ColumnType::Float || type == ColumnType::UInt16 || type == ColumnType::UInt32;
}

double scalarAt(ColumnType type, std::span<const std::byte> column, std::size_t row)
{
    return type == ColumnType::Float    ? numberAt<float>(column, row)
           : type == ColumnType::UInt16 ? numberAt<std::uint16_t>(column, row)
                                        : numberAt<std::uint32_t>(column, row);
}

std::vector<std::byte> scalarBytes(ColumnType type, double value)
{
    return type == ColumnType::Float    ? bytesOf<float>(value)
           : type == ColumnType::UInt16 ? bytesOf<std::uint16_t>(value)
                                        : bytesOf<std::uint32_t>(value);
}

bool isSameValue(ColumnType type, std::span<const std::byte> a, std::span<const std::byte> b)
{
    return floatsPerValue(type) > 0 ? std::ranges::equal(floatsOf(type, a), floatsOf(type, b))
                                    : std::ranges::equal(a, b);
}

float nearestLegal(const PropertyInfo& property, float value)
{
    const FloatRange range(property.meta);
    return std::isfinite(value) ? std::clamp(value, range.low, range.high) : range.low;
}

std::optional<IllegalNumber> firstIllegal(const PropertyInfo& property,
                                          std::span<const std::byte> column)
{
    const FloatRange range(property.meta);
    const std::span<const float> numbers = floatsOf(property.column.type, column);
    if (areAllWithin(range, numbers)) {
        return std::nullopt;
    }
    const auto wrong =
        std::ranges::find_if(numbers, [&](float each) { return !range.contains(each); });
    return IllegalNumber{static_cast<std::size_t>(wrong - numbers.begin()) /
                             floatsPerValue(property.column.type),
                         *wrong};
}

std::size_t countIllegal(const PropertyInfo& property, std::span<const std::byte> column)
{
    const FloatRange range(property.meta);
    const std::span<const float> numbers = floatsOf(property.column.type, column);
    if (areAllWithin(range, numbers)) {
        return 0;
    }
    const std::size_t width = floatsPerValue(property.column.type);
    std::size_t rows = 0;
    for (std::size_t i = 0; i < numbers.size(); i += width) {
        rows += areAllWithin(range, numbers.subspan(i, width)) ? 0 : 1;
    }
    return rows;
}

} // namespace crowd::model
