// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/SetNumber.h"

namespace crowd::behavior {

inline ActionStatus run(const ActionScope& scope, const model::actions::SetNumber& action)
{
    changeNumber(scope, action.number, action.value, false);
    return ActionStatus::Done;
}

} // namespace crowd::behavior
