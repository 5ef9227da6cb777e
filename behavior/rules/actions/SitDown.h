// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/SitDown.h"

namespace crowd::behavior {

/// On the nearest free seat; over where none is free.
inline ActionStatus run(const ActionScope& scope, const model::actions::SitDown& action)
{
    const std::uint32_t agent = scope.agent;
    if (scope.progress().isStarted || scope.host.isSeated(agent) || scope.host.isGone(agent)) {
        return scope.host.isSittingDown(agent) ? ActionStatus::Running : ActionStatus::Done;
    }
    scope.progress().isStarted = true;
    if (!scope.host.sit(agent, action.metres)) {
        if (!scope.host.hasSeats()) {
            scope.report(QT_TRANSLATE_NOOP(
                "Messages",
                "Rule \"%1\" lets characters sit down, but the scene has no seats. Bring a "
                "stage with seats along."));
        }
        return ActionStatus::Done;
    }
    scope.self().errand.goal = 0;
    holdPlace(scope.state, agent, 0);
    return ActionStatus::Running;
}

} // namespace crowd::behavior
