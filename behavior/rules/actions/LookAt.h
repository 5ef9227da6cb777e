// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "behavior/rules/Aims.h"
#include "behavior/rules/Pursuit.h"
#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/LookAt.h"

namespace crowd::behavior {

/// Turns to it wherever it goes.
inline ActionStatus run(const ActionScope& scope, const model::actions::LookAt& action)
{
    ActionProgress& progress = scope.progress();
    if (!progress.isStarted) {
        progress.isStarted = true;
        progress.until = endAfter(scope, action.seconds);
        progress.nextUpdate = scope.now();
    }
    if (scope.now() >= progress.nextUpdate) {
        progress.nextUpdate = scope.now() + kAimUpdateSeconds;
        if (const std::optional<Aim> aim = aimOf(scope, action)) {
            scope.host.turnTo(scope.agent, aim->point);
        } else if (action.aim == model::ActionAim::Sender) {
            return ActionStatus::Done; // there is nothing to look at, nor will there be
        }
    }
    return scope.now() >= progress.until ? ActionStatus::Done : ActionStatus::Running;
}

} // namespace crowd::behavior
