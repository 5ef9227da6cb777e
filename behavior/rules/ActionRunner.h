// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "behavior/rules/RuleState.h"
#include "behavior/rules/actions/ActionScope.h"

/// Has agents do what their rules say, action by action until one takes time. The run time of each
/// kind of action is a header in behavior/rules/actions, called as its data in model/rules/actions;
/// the list there is the list here.
namespace crowd::behavior {

/// One call of the action's run().
[[nodiscard]] ActionStatus runAction(const ActionScope& scope, const model::Action& action);
/// Goes on with the rule that somebody is busy with, and with those that wait for him.
void runAgent(const RuleScope& scope, std::uint32_t agent);
/// Goes on with all who are busy, those first to whom it did not come in the step before.
void runAgents(const RuleScope& scope);
/// Who has got where his rule sent him goes on with it, before others hear that he arrived.
void runArrived(const RuleScope& scope);
/// Fires the rules that wait for a clip to be over. What else the rule that had it played has to do
/// comes first.
void fireForEndedClips(const RuleScope& scope);

} // namespace crowd::behavior
