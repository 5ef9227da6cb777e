// SPDX-License-Identifier: MIT
#pragma once

class QMenu;

namespace crowd::widgets {
class EditorState;
}

namespace crowd::app {

/// The looks of render/Looks.h and those of the scene, to choose how the view is drawn.
void fillLookMenu(QMenu& menu, widgets::EditorState& state);

} // namespace crowd::app
