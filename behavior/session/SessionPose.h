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

#include "behavior/rules/OwnNumber.h"
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

    /// Of one that goes by the clock, whose `place` is that at time 0.
    [[nodiscard]] double placeAt(double seconds) const
    {
        return clipSeconds > 0.0F
                   ? place + seconds * static_cast<double>(rate) / static_cast<double>(clipSeconds)
                   : place;
    }
};

/// Bits of what somebody shows.
enum PoseFlag : std::uint8_t {
    kPoseLive = 1,   ///< the session moves him
    kPoseLooped = 2, ///< his clip
    kPoseGone = 4,   ///< has left the scene
    kPoseClock = 8,  ///< his clip goes by the clock: its place is that at time 0
    kPoseFading = 16 ///< he comes from another clip
};

/// What somebody did before he changed his clip.
struct PoseFade
{
    std::uint32_t person = 0; ///< index in the pose
    ClipPlace from;           ///< where it would be by now
    double begin = 0.0;       ///< seconds
};

/// An angle within half a turn of 0. (The library's remainder takes as long as a whole step.)
[[nodiscard]] inline float wrappedRadians(float angle)
{
    constexpr float kTurn = 2.0F * std::numbers::pi_v<float>;
    constexpr float kRounds = 12582912.0F; // what is added to it and taken away is a whole number
    const float turns = angle * (1.0F / kTurn);
    return angle - kTurn * ((turns + kRounds) - kRounds);
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

/// Everybody whom a session moves at one of its steps; whoever is not here is as the scene says.
/// Immutable once published; read on any thread.
struct SessionPose
{
    std::uint64_t step = 0;
    double seconds = 0.0;
    // One each for everybody.
    std::vector<model::IndividualId> ids; ///< ascending
    std::vector<float> x;                 ///< metres
    std::vector<float> y;
    std::vector<float> z;
    std::vector<float> headings;          ///< radians
    std::vector<std::uint16_t> clips;     ///< as the clip column counts
    std::vector<float> rates;             ///< playback speed
    std::vector<float> clipSeconds;       ///< 0: a pose
    std::vector<float> places;            ///< in the clip; loops 0..1
    std::vector<std::uint8_t> flags;      ///< PoseFlag
    std::vector<model::SeatId> seats;     ///< empty: nobody's is another than in the scene
    std::vector<PoseFade> fades;          ///< ascending
    bool hasSeats = false;                ///< somebody's seat is not the scene's
    std::size_t gone = 0;                 ///< people who have left the scene
    std::vector<model::IndividualId> lit; ///< for whom a rule fired lately; ascending
    std::shared_ptr<const std::vector<SetLook>> looks;     ///< ascending ids; null: nobody's
    std::shared_ptr<const std::vector<OwnNumber>> numbers; ///< see RuleEngine::ownNumbers
};

using SessionPosePtr = std::shared_ptr<const SessionPose>;

/// Puts people where they are at frame.seconds, between two steps (the second may be the first).
/// People whom the frame does not have are left out. Who has left is put far below the ground.
void applyPose(const SessionPose& before, const SessionPose& after, model::CrowdFrame& frame);

} // namespace crowd::behavior
