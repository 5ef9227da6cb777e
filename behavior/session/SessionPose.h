// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "model/scene/CrowdFrame.h"

namespace crowd::behavior {

/// A clip and where somebody is in it.
struct ClipPlace
{
    std::uint16_t clip = 0; ///< as the clip column counts
    bool isLooped = true;
    float rate = 1.0F;        ///< playback speed
    float clipSeconds = 0.0F; ///< 0: a pose
    double place = 0.0;       ///< loops 0..1
};

/// What one individual does at the end of a step.
struct PersonPose
{
    model::IndividualId id = 0;
    std::uint16_t clip = 0; ///< as the clip column counts
    bool isLooped = true;
    bool isGone = false; ///< has left the scene
    model::SeatId seat = model::kNoSeat;
    glm::vec3 position{0.0F}; ///< metres
    float heading = 0.0F;     ///< radians
    float rate = 1.0F;        ///< playback speed
    float clipSeconds = 0.0F; ///< 0: a pose
    double place = 0.0;       ///< in the clip; loops 0..1
    ClipPlace from;           ///< what it did before, where it would be by now
    double fadeBegin = -1.0;  ///< seconds, when it changed over; below 0: it did not
};

/// An angle within half a turn of 0. (The library's remainder takes as long as a whole step.)
[[nodiscard]] inline float wrappedRadians(float angle)
{
    constexpr float kTurn = 2.0F * std::numbers::pi_v<float>;
    return angle - kTurn * std::floor(angle / kTurn + 0.5F);
}

/// Seconds from one clip to the next.
inline constexpr double kFadeSeconds = 0.25;

/// What rules have set of somebody since the session began, beside where he is and what he does.
struct SetLook
{
    model::IndividualId id = 0;
    std::uint8_t tinted = 0; ///< bit i: slot i
    std::array<model::Tint, model::kMaxTintSlots> tints{};
    std::optional<float> height;
    std::optional<std::uint64_t> tags;
    // Of the clip while he stands or sits; already part of what is shown of him.
    std::optional<std::uint16_t> clip;
    std::optional<float> playbackSpeed;
    std::optional<float> phase;
};

/// An artist's number of somebody, where rules have made another one of it.
struct OwnNumber
{
    model::NumberId number = 0;
    model::IndividualId id = 0;
    float value = 0.0F;
};

/// Everybody whom a session moves at one of its steps; whoever is not here is as the scene says.
/// Immutable once published; read on any thread.
struct SessionPose
{
    std::uint64_t step = 0;
    double seconds = 0.0;
    std::vector<PersonPose> people;                    ///< ascending ids
    bool hasSeats = false;                             ///< somebody's seat is not the scene's
    std::vector<model::IndividualId> lit;              ///< for whom a rule fired lately; ascending
    std::shared_ptr<const std::vector<SetLook>> looks; ///< ascending ids; null: nobody's
    std::shared_ptr<const std::vector<OwnNumber>> numbers; ///< see RuleEngine::ownNumbers
};

using SessionPosePtr = std::shared_ptr<const SessionPose>;

/// Puts people where they are at frame.seconds, between two steps (the second may be the first).
/// People whom the frame does not have are left out. Who has left is put far below the ground.
void applyPose(const SessionPose& before, const SessionPose& after, model::CrowdFrame& frame);

} // namespace crowd::behavior
