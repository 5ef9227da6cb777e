// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/BrushSettings.h"
#include "widgets/docks/FieldForm.h"

namespace crowd::widgets {

/// Everything that a brush of a kind can be set to: area and reach, its own fields, the operator.
/// Bound to the state's brush of that kind.
[[nodiscard]] FieldForm* makeBrushForm(EditorState& state, model::BrushKind kind, QWidget* parent);

} // namespace crowd::widgets
