// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "behavior/rules/triggers/TriggerScope.h"
#include "model/rules/triggers/Waited.h"

namespace crowd::behavior {

/// Somebody has stood still for so long; once for each time that he stands.
inline void evaluate(const TriggerScope& scope, const model::triggers::Waited& trigger)
{
    constexpr float kStandsBelow = 0.1F; // m/s
    const double now = scope.state.clock.seconds;
    fireForAgents(scope, [&](std::uint32_t agent) {
        RuleAgentState& known = scope.of(agent);
        if (scope.host.speed(agent) > kStandsBelow) {
            known.since = -1.0;
            known.wasThere = false;
            return false;
        }
        if (known.since < 0.0) {
            known.since = now;
        }
        return now - known.since >= static_cast<double>(trigger.seconds) &&
               !std::exchange(known.wasThere, true);
    });
}

} // namespace crowd::behavior
