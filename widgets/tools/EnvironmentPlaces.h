// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/state/EditorState.h"

/// Places that act by themselves, as the environment brush makes them. Main thread.
namespace crowd::widgets {

/// Adds a place of the brush's role, with its colour and a name that is free, and selects it: one
/// undo step. 0: it was refused.
model::PlaceId addEnvironment(EditorState& state, model::Place place);

} // namespace crowd::widgets
