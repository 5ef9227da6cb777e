// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/triggers/TriggerScope.h"
#include "model/rules/triggers/StateRecalled.h"

namespace crowd::behavior {

inline void evaluate(const TriggerScope& scope, const model::triggers::StateRecalled& trigger)
{
    for (const RecalledState& each : scope.state.recalled) {
        const bool isMeant = trigger.state == 0 || trigger.state == each.state;
        if (isMeant && scope.isEvaluatedFor(each.agent)) {
            fire(scope, scope.rule, each.agent, {});
        }
    }
}

} // namespace crowd::behavior
