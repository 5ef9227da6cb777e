// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Message.h"

#include "model/scene/Scene.h"

namespace crowd::model {

/// What is readable and yet makes no sense in a scene: places so far away that nobody sees them,
/// rules with clips and slots that neither a template has nor a rule named before. Files may hold
/// such, scripts may not bring it. `problem`: the first one, with its place; kept where it is set.
void checkEnvironment(const Scene& before, const Scene& wanted, Message& problem);

} // namespace crowd::model
