// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/Stop.h"

namespace crowd::behavior {

inline ActionStatus run(const ActionScope& scope, const model::actions::Stop& /*action*/)
{
    scope.host.stop(scope.agent);
    return ActionStatus::Done;
}

} // namespace crowd::behavior
