// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/SetSpeed.h"

namespace crowd::behavior {

/// At 0: as the event that set the rule off says.
inline ActionStatus run(const ActionScope& scope, const model::actions::SetSpeed& action)
{
    const float pace = action.value > 0.0F ? action.value : scope.self().context.payload;
    scope.host.setPace(scope.agent, pace);
    return ActionStatus::Done;
}

} // namespace crowd::behavior
