// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/state/EditorState.h"

/// Edits of all that is selected.
namespace crowd::widgets {

/// Also those who look like one of the selected, as far as looks are chosen: the same template,
/// materials, tints and parts.
void selectSimilar(EditorState& state);
/// Also those who stand beside the selected; the other way round.
void growSelection(EditorState& state);
void shrinkSelection(EditorState& state);

/// Takes the selected people out of the scene: one undo step, none when nobody is selected (and a
/// remark saying so).
void deleteSelection(EditorState& state);

/// Puts those of the selected people, or of all when nobody is selected, who stand where nobody can
/// walk on the nearest ground: one undo step, none when nobody does.
void putSelectionOnGround(EditorState& state);

} // namespace crowd::widgets
