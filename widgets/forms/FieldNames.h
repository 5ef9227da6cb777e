// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "widgets/forms/FieldForm.h"

/// Controls for what goes by a name: of templates, and of features.
namespace crowd::widgets {

class ClipMix;

/// A choice of names, with what is shown for each.
void addName(FieldForm& form, const FieldForm::Bound& bound, const QStringList& texts,
             const std::vector<std::string>& names);
/// Names with weights.
void addMix(FieldForm& form, const FieldForm::Bound& bound, ClipMix* mix);
/// False: it is no control of this file.
[[nodiscard]] bool addNamedControl(FieldForm& form, const FieldForm::Bound& bound);

} // namespace crowd::widgets
