// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

class QWidget;

/// Rows of forms, as who looks for one by its name needs them. Main thread only.
namespace crowd::widgets {

/// As the artist reads it, without mnemonic; empty: a row that is not called anything.
[[nodiscard]] QString nameOfRow(const QWidget& row);
[[nodiscard]] QString tipOfRow(const QWidget& row);
/// What takes the keyboard; null: nothing does.
[[nodiscard]] QWidget* controlOfRow(QWidget& row);
/// Scrolls all that the row is in.
void scrollTo(QWidget& row);
/// Draws a border around it for a moment.
void flashRow(QWidget& row);

} // namespace crowd::widgets
