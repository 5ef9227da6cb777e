// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/ControlFlow.h"
#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/Repeat.h"

namespace crowd::behavior {

inline ActionStatus run(const ActionScope& scope, const model::actions::Repeat& action)
{
    enterLoop(scope.self(), scope.actions(), action.times);
    return ActionStatus::Jumped;
}

} // namespace crowd::behavior
