// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/session/RunBeginning.h"
#include "model/base/Result.h"
#include "model/scene/Scene.h"
#include "model/scene/Take.h"

namespace crowd::behavior {

/// A run that goes on from a moment of a kept take, as that is seen: with what was done to people
/// of it by hand until then. `scene`: whose people they are. Error: it cannot be read.
[[nodiscard]] model::Result<RunBeginning> beginningIn(const model::Take& take,
                                                      const model::Scene& scene, double seconds);

} // namespace crowd::behavior
