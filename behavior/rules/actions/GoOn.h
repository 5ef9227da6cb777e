// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/GoOn.h"

namespace crowd::behavior {

inline ActionStatus run(const ActionScope& scope, const model::actions::GoOn& /*action*/)
{
    holdPlace(scope.state, scope.agent, 0);
    scope.host.goOn(scope.agent);
    return ActionStatus::Done;
}

} // namespace crowd::behavior
