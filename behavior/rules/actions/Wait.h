// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/base/Random.h"
#include "model/rules/actions/Wait.h"

namespace crowd::behavior {

/// Up to half as long again, or half as long.
inline ActionStatus run(const ActionScope& scope, const model::actions::Wait& action)
{
    ActionProgress& progress = scope.progress();
    if (!progress.isStarted) {
        progress.isStarted = true;
        const float share = 0.5F + draw(scope, scope.agent, model::hashKeys(scope.self().line, 91));
        progress.until = scope.now() + static_cast<double>(action.seconds * share);
    }
    return scope.now() >= progress.until ? ActionStatus::Done : ActionStatus::Running;
}

} // namespace crowd::behavior
