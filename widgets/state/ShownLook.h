// SPDX-License-Identifier: MIT
#pragma once

#include "model/scene/Scene.h"
#include "widgets/state/EditorState.h"

/// Which of its scene's looks the view is drawn in.
namespace crowd::widgets {

/// Null: none, it is as the view's options say.
[[nodiscard]] const model::LookPreset* shownLook(const EditorState& state);
/// 0, or one that is gone: none, the scene as it is lit.
void showLook(EditorState& state, model::LookId id);
/// As the view comes to a camera: it takes on the look of that. A camera without one leaves the
/// view as it is, unless its look is another camera's.
void showLookOf(EditorState& state, const model::NamedCamera& camera);

} // namespace crowd::widgets
