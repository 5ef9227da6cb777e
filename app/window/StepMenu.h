// SPDX-License-Identifier: MIT
#pragma once

class QMenu;

namespace crowd::widgets {
class EditorState;
}

namespace crowd::app {

/// How finely the scene's time is divided while it plays, to choose in a menu; one undo step. Holds
/// from the next Play on.
void fillStepMenu(QMenu& menu, widgets::EditorState& state);

} // namespace crowd::app
