// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/RemoveTag.h"

namespace crowd::behavior {

inline ActionStatus run(const ActionScope& scope, const model::actions::RemoveTag& action)
{
    setTag(scope, action.tag, false);
    return ActionStatus::Done;
}

} // namespace crowd::behavior
