// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/AddToNumber.h"

namespace crowd::behavior {

inline ActionStatus run(const ActionScope& scope, const model::actions::AddToNumber& action)
{
    changeNumber(scope, action.number, action.value, true);
    return ActionStatus::Done;
}

} // namespace crowd::behavior
