// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QList>

class QAction;

namespace crowd::app {

/// Entries of a menu or a menu bar, and of the menus in it, that have the mnemonic of an earlier
/// one get a letter of theirs that is free, or none.
void setMnemonicsApart(const QList<QAction*>& entries);

} // namespace crowd::app
