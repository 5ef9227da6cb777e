// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

#include <glm/vec2.hpp>

namespace crowd::app {

/// Two whole numbers around a separator ("1280x720", "0-99"); nothing if it is anything else.
[[nodiscard]] inline std::optional<glm::ivec2> parsePair(std::string_view text, char separator)
{
    const auto number = [](std::string_view digits) -> std::optional<int> {
        int value = 0;
        const char* end = digits.data() + digits.size();
        const auto [last, problem] = std::from_chars(digits.data(), end, value);
        return problem == std::errc() && last == end ? std::optional(value) : std::nullopt;
    };
    const std::size_t middle = text.find(separator);
    if (middle == std::string_view::npos) {
        return std::nullopt;
    }
    const auto first = number(text.substr(0, middle));
    const auto second = number(text.substr(middle + 1));
    return first && second ? std::optional(glm::ivec2(*first, *second)) : std::nullopt;
}

/// "WIDTHxHEIGHT" in pixels, each from 1 to what pictures have at most.
[[nodiscard]] inline std::optional<glm::ivec2> parseSize(std::string_view text)
{
    constexpr int kLargestSide = 32768;
    const auto size = parsePair(text, 'x');
    const bool isUsable =
        size && size->x >= 1 && size->y >= 1 && size->x <= kLargestSide && size->y <= kLargestSide;
    return isUsable ? size : std::nullopt;
}

} // namespace crowd::app
