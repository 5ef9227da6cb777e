// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/motion/TravelEvents.h"
#include "behavior/rules/triggers/TriggerScope.h"
#include "model/rules/triggers/PathEnded.h"

namespace crowd::behavior {

/// Somebody came to the end of the path, or of any where it is 0.
inline void evaluate(const TriggerScope& scope, const model::triggers::PathEnded& trigger)
{
    fireForTravellers(scope, [&](std::uint32_t agent) {
        return (scope.host.travelEvents()[agent] & kEndedPath) != 0 &&
               (trigger.path == 0 || scope.host.pathOf(agent) == trigger.path);
    });
}

} // namespace crowd::behavior
