// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/WaitForEvent.h"

namespace crowd::behavior {

/// Hears it in EventDelivery.h.
inline ActionStatus run(const ActionScope& scope, const model::actions::WaitForEvent& action)
{
    ActionProgress& progress = scope.progress();
    if (!progress.isStarted) {
        progress.isStarted = true;
        progress.until = endAfter(scope, action.seconds);
    }
    const bool isOver = progress.hasHeardEvent || scope.now() >= progress.until;
    return isOver ? ActionStatus::Done : ActionStatus::Running;
}

} // namespace crowd::behavior
