// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/forms/FieldForm.h"

namespace crowd::widgets {

/// Adds the control of a field that refers to something: a slot, clips, a path, a tag, an event, a
/// point. False where the control of its type is wanted, beside it or alone.
bool addReferenceControl(FieldForm& form, const FieldForm::Bound& bound);

} // namespace crowd::widgets
