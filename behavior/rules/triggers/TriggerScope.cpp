// SPDX-License-Identifier: MIT
#include "behavior/rules/triggers/TriggerScope.h"

#include <algorithm>

namespace crowd::behavior {

bool isInPlace(const RuleScope& scope, std::uint32_t agent, model::PlaceId place)
{
    const glm::vec3 at = scope.host.position(agent);
    return std::ranges::any_of(scope.state.places.places(), [&](const model::Place& each) {
        return (place == 0 || each.id == place) && flatDistance(each.position, at) <= each.radius;
    });
}

} // namespace crowd::behavior
