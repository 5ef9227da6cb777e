// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

namespace crowd::widgets {

/// The text of a menu's entry, a button or a label as it is read: without the ampersand that
/// underlines a letter; two of them are one.
[[nodiscard]] QString menuText(const QString& text);

} // namespace crowd::widgets
