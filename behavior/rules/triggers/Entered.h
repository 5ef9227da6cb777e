// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "behavior/rules/triggers/TriggerScope.h"
#include "model/rules/triggers/Entered.h"

namespace crowd::behavior {

inline void evaluate(const TriggerScope& scope, const model::triggers::Entered& trigger)
{
    fireForAgents(scope, [&](std::uint32_t agent) {
        const bool isThere = isInPlace(scope, agent, trigger.place);
        return !std::exchange(scope.of(agent).wasThere, isThere) && isThere;
    });
}

} // namespace crowd::behavior
