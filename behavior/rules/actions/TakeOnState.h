// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/TakeOnState.h"

namespace crowd::behavior {

/// What comes next in the sequence begins when he has it: tags, for one, are part of a state.
inline ActionStatus run(const ActionScope& scope, const model::actions::TakeOnState& action)
{
    if (scope.progress().isStarted) {
        return ActionStatus::Done;
    }
    scope.progress().isStarted = true;
    if (scope.host.takeOnState(scope.agent, action)) {
        return ActionStatus::Running;
    }
    scope.report(
        QT_TRANSLATE_NOOP("Messages", "Rule \"%1\": the state is not there. Choose another one."));
    return ActionStatus::Done;
}

} // namespace crowd::behavior
