// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtCore/QString>

#include "model/rules/Rule.h"

namespace crowd::widgets {

/// Numbers counted from 0 as people write them, counted from 1: "1, 3-5".
[[nodiscard]] QString numberListText(const std::vector<int>& numbers);
/// The inverse: ascending, each once, from 0; what is no number is left out.
[[nodiscard]] std::vector<int> numberListOf(const QString& text);

/// Tags as the artist names them, those without a name by number: "brave, 3-5".
[[nodiscard]] QString tagListText(const std::vector<model::TagName>& names, std::uint64_t tags);
[[nodiscard]] std::uint64_t tagListOf(const std::vector<model::TagName>& names,
                                      const QString& text);

} // namespace crowd::widgets
