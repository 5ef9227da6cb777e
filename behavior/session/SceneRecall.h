// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "behavior/session/SessionParts.h"
#include "model/states/StateKeeping.h"

namespace crowd::behavior {

/// The scene was edited, and people change over to what is new.
void adoptRecall(SessionParts& parts, const model::Scene& scene, const model::ChangeOver& change);

/// People take on a state of the scene in the session alone; the others keep what they have.
[[nodiscard]] model::StateRecall recallInSession(SessionParts& parts,
                                                 const model::ChangeOver& change);

/// What rules have set of these properties counts no more, nor the clip that they let somebody
/// play.
void forgetRuleValues(SessionParts& parts, std::span<const model::IndividualId> ids,
                      const model::ColumnSet& columns);

/// At the end of a step: who was told so by a rule takes on a state.
void recallForRules(SessionParts& parts);
/// Before rules run: they hear of those who begin to take on a state by now.
void tellRulesOfRecalls(SessionParts& parts);

} // namespace crowd::behavior
