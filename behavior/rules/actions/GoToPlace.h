// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/Errands.h"
#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/GoToPlace.h"

namespace crowd::behavior {

inline ActionStatus run(const ActionScope& scope, const model::actions::GoToPlace& action)
{
    return travel(scope, {action.choice, action.place, action.path});
}

} // namespace crowd::behavior
