// SPDX-License-Identifier: MIT
#pragma once

class QWidget;

namespace crowd::widgets {

/// While `list` has the focus, the keys of its own actions are the list's, whatever the window has
/// them for: to Qt a key that both answer is ambiguous, and it gives it to neither. An action that
/// is off keeps its key; nothing happens then. Call it once, on the thread of the window; actions
/// that are added later count as well. It goes with the list.
void keepKeysOfOwnActions(QWidget& list);

} // namespace crowd::widgets
