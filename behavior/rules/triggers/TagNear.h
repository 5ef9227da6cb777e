// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "behavior/rules/triggers/TriggerScope.h"
#include "model/rules/triggers/TagNear.h"

namespace crowd::behavior {

/// Somebody else with the tag came near.
inline void evaluate(const TriggerScope& scope, const model::triggers::TagNear& trigger)
{
    const RuleHost& host = scope.host;
    const NearCells tagged = cellsOfTagged(host, scope.state.agents, trigger.tag);
    for (std::uint32_t agent = 0; agent < scope.state.agents.size(); ++agent) {
        if (host.isGone(agent)) {
            continue;
        }
        const std::uint32_t who = tagged.nearest(host.position(agent), trigger.metres, agent);
        const bool isNear = who != kNoAgent;
        if (std::exchange(scope.of(agent).wasThere, isNear) != isNear && isNear) {
            fire(scope, scope.rule, agent, {0.0F, host.position(who), true, host.id(who)});
        }
    }
}

} // namespace crowd::behavior
