// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "model/population/Columns.h"
#include "model/view/View.h"

/// Values as Python text that gives exactly the same values again, whatever the locale.
namespace crowd::app {

inline constexpr std::size_t kIndent = 4; ///< spaces a level

/// The shortest text that comes back as this very number through Python's double.
[[nodiscard]] std::string pythonText(float value);
[[nodiscard]] std::string pythonText(double value);
[[nodiscard]] std::string pythonText(bool value);
template<std::integral T>
[[nodiscard]] std::string pythonText(T value)
{
    return std::to_string(value);
}
[[nodiscard]] std::string pythonText(std::string_view value);
[[nodiscard]] inline std::string pythonText(const std::string& value)
{
    return pythonText(std::string_view(value));
}
[[nodiscard]] std::string pythonText(const glm::vec3& value);
[[nodiscard]] std::string pythonText(const glm::quat& value); ///< (w, x, y, z)
[[nodiscard]] std::string pythonText(const model::Camera& camera);
[[nodiscard]] std::string pythonText(const model::Tint& tint);

/// "[a, b, c]", broken into lines of at most so many characters that are indented by four more
/// than `indent`.
[[nodiscard]] std::string pythonList(const std::vector<std::string>& items, std::size_t indent,
                                     char open = '[', char close = ']');
/// Ids; consecutive ones as a range.
[[nodiscard]] std::string pythonIds(std::span<const model::IndividualId> ids, std::size_t indent);
/// Values of a column: one for all where `bytes` holds one stride, else a list.
[[nodiscard]] std::string pythonColumn(model::ColumnId column, std::span<const std::byte> bytes,
                                       std::size_t indent);

} // namespace crowd::app
