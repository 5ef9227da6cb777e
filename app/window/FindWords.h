// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtCore/QString>

/// Words by which artists look for things that are called otherwise here: "wall", "render",
/// "lamp". Main thread only.
namespace crowd::app {

/// In the language of the window, with blanks between; empty: none. `id` is an action's, or
/// "panel-" and the object name of a panel.
[[nodiscard]] QString findWords(const QString& id);
/// The ids that have some.
[[nodiscard]] std::vector<QString> idsWithFindWords();

} // namespace crowd::app
