// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/BrushSettings.h"
#include "widgets/forms/FieldForm.h"

namespace crowd::widgets {

/// A brush that is shown and set by a form.
struct BrushTarget
{
    std::function<const model::BrushSettings&()> read;
    std::function<void(const model::BrushSettings&)> write;
};

/// Everything that a brush of a kind can be set to: area and reach, its own fields, the operator.
/// Bound to the state's brush of that kind.
[[nodiscard]] FieldForm* makeBrushForm(EditorState& state, model::BrushKind kind, QWidget* parent);
/// The same of another brush, whose kind stays as it is; without choosing in the picture.
[[nodiscard]] FieldForm* makeBrushForm(EditorState& state, const BrushTarget& brush,
                                       QWidget* parent);

} // namespace crowd::widgets
