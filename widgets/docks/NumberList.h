// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtCore/QString>

namespace crowd::widgets {

/// Numbers counted from 0 as people write them, counted from 1: "1, 3-5".
[[nodiscard]] QString numberListText(const std::vector<int>& numbers);
/// The inverse: ascending, each once, from 0; what is no number is left out.
[[nodiscard]] std::vector<int> numberListOf(const QString& text);

} // namespace crowd::widgets
