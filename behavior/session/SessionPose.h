// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "behavior/agents/ClipPlace.h"
#include "behavior/agents/PropertyOverrides.h"
#include "behavior/agents/StateFades.h"
#include "behavior/rules/OwnNumber.h"
#include "model/scene/CrowdFrame.h"

namespace crowd::behavior {

/// The clip that somebody shows less and less of, after a change to another one.
struct PoseFade
{
    std::uint32_t person = 0; ///< index in the pose
    ClipPlace from;           ///< goes on while it fades
    double begin = 0.0;       ///< seconds
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
    /// What rules have set of properties; those that are columns here too are part of these
    /// already.
    std::shared_ptr<const OverrideColumns> overrides;      ///< null: nothing
    std::shared_ptr<const std::vector<OwnNumber>> numbers; ///< see RuleEngine::ownNumbers
    /// What states that were recalled in the session alone have made of people; null: nothing.
    std::shared_ptr<const OverrideColumns> recalled;
    model::Population people; ///< where there is such: the scene's, with these values
    /// Version of the scene's population that the session knows.
    std::uint64_t sceneVersion = 0;
    std::shared_ptr<const FadeColumns> stateFades;     ///< null: nobody changes over
    std::shared_ptr<const model::LightCues> lightCues; ///< null: as the scene has them
};

using SessionPosePtr = std::shared_ptr<const SessionPose>;

/// Puts people where they are at frame.seconds, between two steps (the second may be the first).
/// People whom the frame does not have are left out. Who has left is put far below the ground.
void applyPose(const SessionPose& before, const SessionPose& after, model::CrowdFrame& frame);

} // namespace crowd::behavior
