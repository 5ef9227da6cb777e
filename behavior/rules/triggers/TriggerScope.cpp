// SPDX-License-Identifier: MIT
#include "behavior/rules/triggers/TriggerScope.h"

#include <algorithm>

#include "behavior/motion/TravelEvents.h"
#include "model/scene/PlaceShape.h"

namespace crowd::behavior {

bool isInPlace(const RuleScope& scope, std::uint32_t agent, model::PlaceId place)
{
    const glm::vec3 at = scope.host.position(agent);
    return std::ranges::any_of(scope.state.places.places(), [&](const model::Place& each) {
        return (place == 0 || each.id == place) && model::isWithin(each, at);
    });
}

bool hasArrived(const RuleScope& scope, std::uint32_t agent, model::PlaceId place)
{
    const std::uint8_t events = scope.host.travelEvents()[agent];
    const bool isErrand = (events & kEndedErrand) != 0;
    const model::PlaceId reached =
        isErrand ? scope.state.agents[agent].errand.arrived : scope.host.reachedPlace(agent);
    return (isErrand ? reached != 0 : (events & kReachedPlace) != 0) &&
           (place == 0 || reached == place);
}

} // namespace crowd::behavior
