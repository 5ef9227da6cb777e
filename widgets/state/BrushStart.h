// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

#include "widgets/state/EditorState.h"

/// Brushes in whose settings nothing is chosen yet: a first stroke is to show something.
namespace crowd::widgets {

/// Called when the brush is taken up: chooses what the scene offers where the artist has chosen
/// nothing that the scene has. Templates: those that new people come of. Clips: those for standing
/// or sitting of the templates in use. Parts: nobody lacks any, so they are taken off. Scripts: the
/// first one. False: the scene offers nothing yet.
bool startBrush(EditorState& state, model::BrushKind kind);

/// What a stroke lacks, or does instead, for the plate at the cursor; empty: nothing.
[[nodiscard]] QString missingOf(const EditorState& state, model::BrushKind kind);

} // namespace crowd::widgets
