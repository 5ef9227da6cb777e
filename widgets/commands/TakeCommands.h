// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "model/brush/changes/Retake.h"
#include "model/scene/Take.h"
#include "widgets/state/EditorState.h"

/// What panels, menus and keys do with takes. They say in the status bar what came of it.
namespace crowd::widgets {

/// Something has been played that could be kept, and nothing is being kept yet.
[[nodiscard]] bool canKeepTake(const EditorState& state);
/// What has been played becomes the scene's next take, in the background.
void keepTake(EditorState& state);
/// The selected people of the take that is shown do something else in the play range, where that
/// is set, else from the moment shown to the take's end.
[[nodiscard]] bool canRetake(const EditorState& state);
/// Those do. False: no take is shown, or another one is being kept still; nothing is said.
bool retake(EditorState& state, std::span<const model::IndividualId> ids,
            const model::RetakeSettings& how);
void retakeSelected(EditorState& state);
/// 0: the scene as it plays.
void showTake(EditorState& state, model::TakeId id);
/// The next one of the scene's takes, after the last one the scene as it plays.
void showNextTake(EditorState& state);

} // namespace crowd::widgets
