// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <numbers>

/// Headings: radians, 0 along +Z, growing towards +X.
namespace crowd::behavior {

/// How fast a body turns.
inline constexpr float kTurnRadiansPerSecond = 4.0F;

/// An angle within half a turn of 0. (The library's remainder takes as long as a whole step.)
[[nodiscard]] inline float wrappedRadians(float angle)
{
    constexpr float kTurn = 2.0F * std::numbers::pi_v<float>;
    constexpr float kRounds = 12582912.0F; // adding and subtracting it rounds to a whole number
    const float turns = angle * (1.0F / kTurn);
    return angle - kTurn * ((turns + kRounds) - kRounds);
}

/// Heading after turning towards another one by at most `most`.
[[nodiscard]] inline float turnedTowards(float heading, float target, float most)
{
    return wrappedRadians(heading + std::clamp(wrappedRadians(target - heading), -most, most));
}

} // namespace crowd::behavior
