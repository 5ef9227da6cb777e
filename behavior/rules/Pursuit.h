// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"

namespace crowd::behavior {

/// Seconds after which an action asks again where the one that it is about is now.
inline constexpr double kAimUpdateSeconds = 0.2;

/// Going to somebody, or after him. Metres, seconds.
struct PursuitSettings
{
    model::AimChoice aim;
    float metres = 0.0F;  ///< how near
    float seconds = 0.0F; ///< at most; 0: however long
    bool isFollowing = false;
};

/// Done: he is there, cannot get there, or the time is over; whoever follows goes on until then.
[[nodiscard]] ActionStatus pursue(const ActionScope& scope, const PursuitSettings& settings);

} // namespace crowd::behavior
