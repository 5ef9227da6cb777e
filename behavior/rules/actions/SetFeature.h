// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/SetFeature.h"

namespace crowd::behavior {

/// What comes next in the sequence begins when he bears it.
inline ActionStatus run(const ActionScope& scope, const model::actions::SetFeature& action)
{
    if (scope.progress().isStarted) {
        return ActionStatus::Done;
    }
    scope.progress().isStarted = true;
    if (scope.host.takeOnFeature(scope.agent, action.feature)) {
        return ActionStatus::Running;
    }
    scope.report(QT_TRANSLATE_NOOP(
        "Messages", "Rule \"%1\": the value of a feature is not there. Choose another one."));
    return ActionStatus::Done;
}

} // namespace crowd::behavior
