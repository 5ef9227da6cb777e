// SPDX-License-Identifier: MIT
#pragma once

namespace crowd::widgets {

class EditorState;

/// Says in the status bar that people move as in a take, so that they cannot be told anything.
/// Whether that is so.
bool saysThatTakeIsShown(EditorState& state);

} // namespace crowd::widgets
