// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>
#include <QtGui/QPalette>

namespace crowd::widgets {

/// How the window is coloured. System: light or dark by the lightness of the palette that the
/// program was started with.
enum class Theme : unsigned char { System, Light, Dark };

[[nodiscard]] QString themeName(Theme theme); ///< "system", "light", "dark": in settings
[[nodiscard]] Theme themeNamed(const QString& name);

[[nodiscard]] bool isDark(const QPalette& palette);

/// Sets style, palette and style sheet of the application, unless they are these already; icons of
/// iconNamed() follow.
void applyTheme(Theme theme);

} // namespace crowd::widgets
