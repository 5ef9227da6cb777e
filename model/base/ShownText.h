// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Texts of files and scripts on their way into messages. UTF-8.
namespace crowd::model {

/// The same with U+FFFD in the place of each byte that is no part of UTF-8.
[[nodiscard]] std::string wellFormed(std::string text);

inline constexpr std::size_t kMostShown = 80; ///< characters

/// Begin and end with "…" between them where it has more characters than `most`: a name of somebody
/// else must not size a window. Not for paths, which are read to the end.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most = kMostShown);

} // namespace crowd::model
