// SPDX-License-Identifier: MIT
#pragma once

#include <QtGui/QIcon>
#include <QtGui/QPixmap>

#include "widgets/state/ToolId.h"

namespace crowd::widgets {

/// The symbol of a tool for buttons, in the theme's text colour. Null when the program was built
/// without its icons.
[[nodiscard]] QIcon toolIcon(ToolId id);
/// The same for a light ground whatever the theme, so many logical pixels wide.
[[nodiscard]] QPixmap toolSymbol(ToolId id, int size, qreal devicePixelRatio);

} // namespace crowd::widgets
