// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/AddTag.h"

namespace crowd::behavior {

inline ActionStatus run(const ActionScope& scope, const model::actions::AddTag& action)
{
    setTag(scope, action.tag, true);
    return ActionStatus::Done;
}

} // namespace crowd::behavior
