// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

namespace crowd::app {

/// f_####.png → f_0007.png; a name without # stays.
[[nodiscard]] QString fileForFrame(const QString& pattern, int frame);
/// show.png → show_####.png; a name that has a place for numbers stays.
[[nodiscard]] QString numberedPattern(const QString& path);

} // namespace crowd::app
