// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include "behavior/rules/PlaceRooms.h"
#include "behavior/rules/actions/ActionScope.h"

/// Sending somebody somewhere: to a point, or to a place that is chosen among several, in turn
/// where it must be free.
namespace crowd::behavior {

/// To a point, at his own pace or at `atLeast` (m/s) where that is faster.
void sendTo(const ActionScope& scope, const glm::vec3& point, float atLeast);
/// To a point that has nothing to do with a place: no place counts him as its guest any more.
void sendAway(const ActionScope& scope, const glm::vec3& point);
/// The errand that he is on: what happened in this step may be the end of the one before.
[[nodiscard]] bool hasErrandEnded(const RuleScope& scope, std::uint32_t agent);
/// Where those stand who are sent to a place: a point in it, as the agent draws it.
[[nodiscard]] glm::vec3 pointIn(const ActionScope& scope, const model::Place& place);

/// To a place and there. Done too where there is nowhere to go and nothing to wait for.
[[nodiscard]] ActionStatus travel(const ActionScope& scope, const PlaceWish& wish);
/// As near to the place that he travels to as others let him, or `ahead` metres before that.
[[nodiscard]] bool isAtGoal(const ActionScope& scope, float ahead);

} // namespace crowd::behavior
