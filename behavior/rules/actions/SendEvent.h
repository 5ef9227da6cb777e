// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "behavior/rules/EventReach.h"
#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/SendEvent.h"

namespace crowd::behavior {

inline void sendEventTo(const ActionScope& scope, std::uint32_t other,
                        const model::actions::SendEvent& action)
{
    const RuleHost& host = scope.host;
    const glm::vec3 at = host.position(scope.agent);
    const float away = host.isGone(other) ? 0.0F : flatDistance(host.position(other), at);
    const double delay = static_cast<double>(away * action.secondsPerMetre);
    scope.state.events.post({scope.now() + delay, action.event, action.value, host.id(other), at,
                             host.id(scope.agent), scope.self().context.calledAt});
}

/// Arrives in the next step at the earliest: no circle of events can close within one.
inline ActionStatus run(const ActionScope& scope, const model::actions::SendEvent& action)
{
    RuleState& state = scope.state;
    const std::vector<std::uint32_t>* candidates = candidatesOf(scope, scope.agent, action);
    const std::size_t asked = candidates != nullptr ? candidates->size() : state.agents.size();
    if (state.events.isFull() || state.budget.asked < asked) {
        if (state.problems.noteOverload()) {
            scope.report(QT_TRANSLATE_NOOP(
                "Messages",
                "Rule \"%1\" sends more events than can be under way; further ones are dropped. It "
                "may "
                "be sending events that make it send again: give it a pause, or say how "
                "often at most."));
        }
        return ActionStatus::Done;
    }
    state.budget.asked -= asked;
    for (std::size_t i = 0; i < asked; ++i) {
        const std::uint32_t other =
            candidates != nullptr ? (*candidates)[i] : static_cast<std::uint32_t>(i);
        if (reaches(scope, scope.agent, other, action)) {
            sendEventTo(scope, other, action);
        }
    }
    return ActionStatus::Done;
}

} // namespace crowd::behavior
