// SPDX-License-Identifier: MIT
#pragma once

#include <QtGui/QColor>
#include <QtGui/QIcon>
#include <QtGui/QPixmap>

namespace crowd::widgets {

/// An icon of resources/icons (NAME.svg), drawn in the text colour that the application's palette
/// has at that moment: lines that are #202020 in the file take that colour, all other colours stay.
/// Null for an unknown name.
[[nodiscard]] QIcon iconNamed(const char* name);
/// The same as a picture of so many logical pixels in a given colour.
[[nodiscard]] QPixmap iconPixmap(const char* name, int size, const QColor& color,
                                 qreal devicePixelRatio = 1.0);

/// A square of a colour beside an entry of a list; not tinted where that is chosen.
[[nodiscard]] QIcon swatchIcon(const QColor& color);

} // namespace crowd::widgets
