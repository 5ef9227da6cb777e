// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/state/EditorState.h"
#include "widgets/tools/ToolInput.h"

/// The keys of the picture, in one table. A main window may offer the same ones as shortcuts; here
/// they work as soon as the picture has the focus.
namespace crowd::widgets {

/// Shift+F takes off.
[[nodiscard]] bool isFlyKey(const KeyInput& input);
/// `[` and `]`: -1 and 1, else 0.
[[nodiscard]] int sizeSteps(const KeyInput& input);
/// `-` and `+`, on the number pad too: -1 and 1, else 0.
[[nodiscard]] int numberSteps(const KeyInput& input);
/// Tools, views, selection: whatever needs no pointer. True when the key was one of them.
bool runStateKey(EditorState& state, const KeyInput& input);

} // namespace crowd::widgets
