// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/triggers/TriggerScope.h"
#include "model/rules/triggers/AheadFree.h"

namespace crowd::behavior {

/// Once for each time that the place before somebody's gets free; who is busy does it after.
inline void evaluate(const TriggerScope& scope, const model::triggers::AheadFree& trigger)
{
    const PlaceWish wish{model::PlaceChoice::Ahead, 0, trigger.path};
    for (std::uint32_t agent = 0; agent < scope.state.agents.size(); ++agent) {
        const model::PlaceId own = scope.state.agents[agent].heldPlace;
        if (own == 0 || scope.host.isGone(agent)) {
            continue;
        }
        RuleAgentState& known = scope.of(agent);
        const bool isFree =
            countedPlaces(scope).choose(wish, scope.host.position(agent), own).has_value();
        const bool isKnown = known.wasThere && known.place == own;
        known.place = own;
        known.wasThere = isFree && (isKnown || fire(scope, scope.rule, agent, {}));
    }
}

} // namespace crowd::behavior
