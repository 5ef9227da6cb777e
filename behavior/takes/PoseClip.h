// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "behavior/agents/ClipPlace.h"
#include "behavior/session/SessionPose.h"

/// Somebody's clip in a pose, for those who change what a take has of him. Any thread.
namespace crowd::behavior {

/// None: the pose does not have him.
inline constexpr std::size_t kNotInPose = ~std::size_t{0};
[[nodiscard]] std::size_t rowOfPerson(const SessionPose& pose, model::IndividualId id);

/// A place that is in the clip: loops begin anew, others stay at their ends.
[[nodiscard]] double wholeTurns(const ClipPlace& clip, double place);
/// As it is written there: of one that goes by the clock the place is that at time 0.
[[nodiscard]] ClipPlace clipOf(const SessionPose& pose, std::size_t row);
/// Writes it; whether it goes by the clock stays as it is.
void putClip(SessionPose& pose, std::size_t row, const ClipPlace& clip);

} // namespace crowd::behavior
