// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "behavior/rules/Aims.h"
#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/TurnTo.h"

namespace crowd::behavior {

inline ActionStatus run(const ActionScope& scope, const model::actions::TurnTo& action)
{
    if (const std::optional<Aim> aim = aimOf(scope, action)) {
        scope.host.turnTo(scope.agent, aim->point);
    }
    return ActionStatus::Done;
}

} // namespace crowd::behavior
