// SPDX-License-Identifier: MIT
#include "app/record/ScriptText.h"

#include <array>
#include <charconv>
#include <cstring>

namespace crowd::app {

using namespace model;

namespace {

constexpr std::size_t kLineWidth = 100;

template<class Number>
std::string shortest(Number value)
{
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    std::string result(text.data(), end);
    // Python reads "1" as a whole number; what is a number here stays one there.
    if (result.find_first_of(".en") == std::string::npos) {
        result += ".0";
    }
    return result;
}

double asDouble(const std::string& text)
{
    double value = 0.0;
    (void)std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

template<class T>
T itemAt(std::span<const std::byte> bytes, std::size_t i)
{
    T value;
    std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
    return value;
}

std::string itemText(ColumnType type, std::span<const std::byte> bytes, std::size_t i)
{
    switch (type) {
    case ColumnType::Float:
        return pythonText(itemAt<float>(bytes, i));
    case ColumnType::Vec3:
        return pythonText(itemAt<glm::vec3>(bytes, i));
    case ColumnType::UInt16:
        return pythonText(itemAt<std::uint16_t>(bytes, i));
    case ColumnType::UInt32:
        return pythonText(itemAt<std::uint32_t>(bytes, i));
    case ColumnType::UInt64:
        return pythonText(itemAt<std::uint64_t>(bytes, i));
    case ColumnType::Tint:
        return pythonText(itemAt<Tint>(bytes, i));
    case ColumnType::Bytes8:
        break;
    }
    std::vector<std::string> numbers;
    for (const std::uint8_t each : itemAt<MaterialChoices>(bytes, i)) {
        numbers.push_back(pythonText(each));
    }
    return pythonList(numbers, 0, '(', ')');
}

} // namespace

std::string pythonText(float value)
{
    const std::string text = shortest(value);
    // Rounding twice, to double and then to float, may end beside it.
    return static_cast<float>(asDouble(text)) == value ? text
                                                       : shortest(static_cast<double>(value));
}

std::string pythonText(double value)
{
    return shortest(value);
}

std::string pythonText(bool value)
{
    return value ? "True" : "False";
}

std::string pythonText(std::string_view value)
{
    std::string text = "\"";
    for (const char each : value) {
        if (each == '"' || each == '\\') {
            text += '\\';
            text += each;
        } else if (static_cast<unsigned char>(each) < 0x20 || each == 0x7F) {
            constexpr const char* kDigits = "0123456789abcdef";
            text += "\\x";
            text += kDigits[static_cast<unsigned char>(each) >> 4U];
            text += kDigits[static_cast<unsigned char>(each) & 15U];
        } else {
            text += each;
        }
    }
    return text + '"';
}

std::string pythonText(const glm::vec3& value)
{
    return '(' + pythonText(value.x) + ", " + pythonText(value.y) + ", " + pythonText(value.z) +
           ')';
}

std::string pythonText(const glm::quat& value)
{
    return '(' + pythonText(value.w) + ", " + pythonText(value.x) + ", " + pythonText(value.y) +
           ", " + pythonText(value.z) + ')';
}

std::string pythonText(const Camera& camera)
{
    const bool isFlat = camera.projection == Projection::Orthographic;
    return "crowdbrush.Camera.exact(" + pythonText(camera.position) + ", " +
           pythonText(camera.orientation) + ",\n    orthographic=" + pythonText(isFlat) +
           ", fov_radians=" + pythonText(camera.fovYRadians) +
           ", height=" + pythonText(camera.orthographicHeight) +
           ", pivot_distance=" + pythonText(camera.pivotDistance) + ')';
}

std::string pythonText(const Tint& tint)
{
    return '(' + pythonText(tint.red) + ", " + pythonText(tint.green) + ", " +
           pythonText(tint.blue) + ", " + pythonText(tint.strength) + ')';
}

std::string pythonList(const std::vector<std::string>& items, std::size_t indent, char open,
                       char close)
{
    std::size_t total = 2;
    for (const std::string& item : items) {
        total += item.size() + 2;
    }
    const bool isShort = total + indent < kLineWidth - kIndent;
    const std::string inner(indent + kIndent, ' ');
    std::string text(1, open);
    std::size_t used = kLineWidth; // the first one starts a line
    for (std::size_t i = 0; i < items.size(); ++i) {
        const bool isLast = i + 1 == items.size();
        if (!isShort && used + items[i].size() + 2 > kLineWidth) {
            text += '\n' + inner;
            used = inner.size();
        } else if (i > 0) {
            text += ' ';
            ++used;
        }
        text += items[i];
        used += items[i].size() + 1;
        if (!isLast || (open == '(' && items.size() == 1)) {
            text += ',';
        }
    }
    if (!isShort) {
        text += '\n' + std::string(indent, ' ');
    }
    return text + close;
}

std::string pythonIds(std::span<const IndividualId> ids, std::size_t indent)
{
    constexpr std::size_t kLongEnough = 4;
    const bool isRange = ids.size() >= kLongEnough && ids.back() - ids.front() == ids.size() - 1;
    if (isRange) {
        return "range(" + pythonText(ids.front()) + ", " + pythonText(ids.back() + 1) + ')';
    }
    std::vector<std::string> items;
    for (const IndividualId id : ids) {
        items.push_back(pythonText(id));
    }
    return pythonList(items, indent);
}

std::string pythonColumn(ColumnId column, std::span<const std::byte> bytes, std::size_t indent)
{
    const ColumnInfo& info = columnInfo(column);
    if (bytes.size() == info.stride) {
        return itemText(info.type, bytes, 0);
    }
    std::vector<std::string> items;
    for (std::size_t i = 0; i < bytes.size() / info.stride; ++i) {
        items.push_back(itemText(info.type, bytes, i));
    }
    return pythonList(items, indent);
}

} // namespace crowd::app
