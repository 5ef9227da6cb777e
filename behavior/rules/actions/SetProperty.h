// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/SetProperty.h"

namespace crowd::behavior {

inline ActionStatus run(const ActionScope& scope, const model::actions::SetProperty& action)
{
    scope.host.setProperty(scope.agent, action, drawClip(scope, action.clips));
    return ActionStatus::Done;
}

} // namespace crowd::behavior
