// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/triggers/TriggerScope.h"
#include "model/rules/triggers/Arrived.h"

namespace crowd::behavior {

/// An errand or a path brought somebody to the place, or to any where it is 0.
inline void evaluate(const TriggerScope& scope, const model::triggers::Arrived& trigger)
{
    fireForTravellers(scope,
                      [&](std::uint32_t agent) { return hasArrived(scope, agent, trigger.place); });
}

} // namespace crowd::behavior
