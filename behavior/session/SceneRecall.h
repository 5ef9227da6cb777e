// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/session/SessionParts.h"
#include "model/states/StateKeeping.h"

namespace crowd::behavior {

/// The scene was edited, and people change over to what is new.
void adoptRecall(SessionParts& parts, const model::Scene& scene, const model::ChangeOver& change);

/// People take on a state of the scene in the session alone; the others keep what they have.
[[nodiscard]] model::StateRecall recallInSession(SessionParts& parts,
                                                 const model::ChangeOver& change);

} // namespace crowd::behavior
