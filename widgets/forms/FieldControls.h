// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/forms/FieldForm.h"

namespace crowd::widgets {

/// Adds the control that suits the type of a field and what it refers to: a slider, a box, a list,
/// a line of text, a curve. Nothing where there is none for its type.
void addControl(FieldForm& form, const FieldForm::Bound& bound);

} // namespace crowd::widgets
