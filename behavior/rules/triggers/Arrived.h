// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/motion/TravelEvents.h"
#include "behavior/rules/triggers/TriggerScope.h"
#include "model/rules/triggers/Arrived.h"

namespace crowd::behavior {

/// An errand or a path brought somebody to the place, or to any where it is 0.
inline void evaluate(const TriggerScope& scope, const model::triggers::Arrived& trigger)
{
    fireForTravellers(scope, [&](std::uint32_t agent) {
        const std::uint8_t events = scope.host.travelEvents()[agent];
        const bool isErrand = (events & kEndedErrand) != 0;
        const model::PlaceId reached =
            isErrand ? scope.state.agents[agent].errand.arrived : scope.host.reachedPlace(agent);
        return (isErrand ? reached != 0 : (events & kReachedPlace) != 0) &&
               (trigger.place == 0 || reached == trigger.place);
    });
}

} // namespace crowd::behavior
