// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/Pursuit.h"
#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/Follow.h"

namespace crowd::behavior {

inline ActionStatus run(const ActionScope& scope, const model::actions::Follow& action)
{
    return pursue(scope, {action, action.metres, action.seconds, true});
}

} // namespace crowd::behavior
