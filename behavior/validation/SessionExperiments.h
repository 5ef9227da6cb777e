// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "behavior/validation/Validation.h"

namespace crowd::behavior {

/// Experiments with whole sessions: stairs and ramps that are set to be slower, the three endings
/// of a path, a rule's sequence to the step.
[[nodiscard]] std::vector<ValidationRow> sessionExperiments();

} // namespace crowd::behavior
