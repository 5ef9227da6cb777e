// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/StandUp.h"

namespace crowd::behavior {

inline ActionStatus run(const ActionScope& scope, const model::actions::StandUp& /*action*/)
{
    ActionProgress& progress = scope.progress();
    if (!progress.isStarted) {
        if (!scope.host.isSeated(scope.agent)) {
            return ActionStatus::Done;
        }
        progress.isStarted = true;
        progress.until = scope.now() + static_cast<double>(scope.host.standUp(scope.agent));
    }
    if (scope.now() < progress.until) {
        return ActionStatus::Running;
    }
    scope.host.leaveSeat(scope.agent);
    return ActionStatus::Done;
}

} // namespace crowd::behavior
