// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/forms/FieldForm.h"

namespace crowd::widgets {

/// Below the control of a FieldRole::Stature: what it comes to in metres, of the templates that the
/// brush creates, else of all of the scene. Nothing where there are none.
void addStatureNote(FieldForm& form, const FieldForm::Bound& bound);
/// "1.61 to 1.89 m".
[[nodiscard]] QString statureText(const model::FieldContext& context,
                                  const model::ValueRange& share);

} // namespace crowd::widgets
