// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "behavior/rules/RuleFiring.h"
#include "behavior/rules/RuleState.h"

/// What the kinds of triggers have in common. Each has a function evaluate(), called once a step
/// for each rule of the kind, which fires the rule for everybody to whom it has happened.
namespace crowd::behavior {

struct TriggerScope : RuleScope
{
    std::uint32_t rule = 0; ///< index

    [[nodiscard]] RuleAgentState& of(std::uint32_t agent) const
    {
        return state.rules[rule].agents[agent];
    }
    /// Who has left is asked only by rules that bring back.
    [[nodiscard]] bool isEvaluatedFor(std::uint32_t agent) const
    {
        return state.rules[rule].reachesGone || !host.isGone(agent);
    }
};

/// Fires for everybody of whom hasHappened(agent) is true, in ascending order.
template<class Happened>
void fireForAgents(const TriggerScope& scope, const Happened& hasHappened)
{
    for (std::uint32_t agent = 0; agent < scope.state.agents.size(); ++agent) {
        if (scope.isEvaluatedFor(agent) && hasHappened(agent)) {
            fire(scope, scope.rule, agent, {});
        }
    }
}

/// The same of those alone to whom something happened on the way in this step.
template<class Happened>
void fireForTravellers(const TriggerScope& scope, const Happened& hasHappened)
{
    for (const std::uint32_t agent : scope.state.travellers) {
        if (scope.isEvaluatedFor(agent) && hasHappened(agent)) {
            fire(scope, scope.rule, agent, {});
        }
    }
}

/// Whether an errand or a path has brought a traveller to the place, or to any where it is 0.
[[nodiscard]] bool hasArrived(const RuleScope& scope, std::uint32_t agent, model::PlaceId place);

/// Whether somebody stands in the place, or in any where it is 0.
[[nodiscard]] bool isInPlace(const RuleScope& scope, std::uint32_t agent, model::PlaceId place);

} // namespace crowd::behavior
