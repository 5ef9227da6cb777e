// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "behavior/motion/TravelEvents.h"
#include "behavior/rules/RelatedAgents.h"
#include "behavior/rules/triggers/TriggerScope.h"
#include "model/rules/triggers/RelatedDid.h"

namespace crowd::behavior {

/// For all to whom whoever did it is related.
inline void fireForRelated(const TriggerScope& scope, std::uint32_t doer,
                           const model::triggers::RelatedDid& trigger)
{
    const TriggerContext context{0.0F, scope.host.position(doer), true,
                                 scope.state.agents.ids()[doer]};
    for (const std::uint32_t other : relatedAgents(scope.state, doer, trigger.relation)) {
        if (scope.isEvaluatedFor(other)) {
            fire(scope, scope.rule, other, context);
        }
    }
}

/// Hearing is told when the event is delivered.
inline void evaluate(const TriggerScope& scope, const model::triggers::RelatedDid& trigger)
{
    if (trigger.deed == model::RelatedDeed::Arrives) {
        for (const std::uint32_t agent : scope.state.travellers) {
            if (hasArrived(scope, agent, trigger.place)) {
                fireForRelated(scope, agent, trigger);
            }
        }
    } else if (trigger.deed == model::RelatedDeed::Leaves) {
        for (std::uint32_t agent = 0; agent < scope.state.agents.size(); ++agent) {
            const bool isThere = isInPlace(scope, agent, trigger.place);
            if (std::exchange(scope.of(agent).wasThere, isThere) && !isThere) {
                fireForRelated(scope, agent, trigger);
            }
        }
    }
}

} // namespace crowd::behavior
