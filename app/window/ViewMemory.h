// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/state/EditorState.h"

namespace crowd::app {

/// Brings back what the switches of the View menu were at the last time, and keeps them from now
/// on. The state outlives the window's part in it.
void rememberView(widgets::EditorState& state);
/// All of them as in a new installation; what the preferences say stays.
void resetView(widgets::EditorState& state);

} // namespace crowd::app
