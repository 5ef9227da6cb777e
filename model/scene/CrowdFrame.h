// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "model/population/Population.h"
#include "model/scene/LightCue.h"
#include "model/scene/Scene.h"

namespace crowd::model {

/// Somebody's change from one clip to another: between the two for a moment, so that no limb jumps.
struct ClipFade
{
    std::uint32_t row = 0;
    std::uint16_t clip = 0; ///< that he comes from, as the clip column counts
    float place = 0.0F;     ///< in it, 0..1
    float share = 1.0F;     ///< 0..1 of the clip that he has now
};

/// What is shown at one moment: an immutable snapshot that the scene (or a running session)
/// publishes and that the renderer, picking and brushes read on any thread. Cheap to make: the
/// population's columns are shared. World frame, metres, seconds.
struct CrowdFrame
{
    Population population;
    /// Assets and clip names; entries without asset are not drawn.
    std::shared_ptr<const std::vector<TemplateEntry>> templates;
    double seconds = 0.0;          ///< the transport's time
    std::vector<ClipFade> fades{}; ///< ascending rows; whoever is not here shows his clip alone
    std::vector<GroupId> hiddenGroups{};          ///< ascending; theirs are neither drawn nor found
    std::shared_ptr<const LightCues> lightCues{}; ///< null: lights are as the scene has them
};

using CrowdFramePtr = std::shared_ptr<const CrowdFrame>;

/// Place in the clip shown for a row, 0..1 (loops wrap, others stay at their end; a pose is 0):
/// phase + seconds × playback speed / clip duration. Evaluated in double.
[[nodiscard]] float shownPhase(const Clip& clip, float phase, float playbackSpeed, double seconds);

/// Foot point at which a clip is drawn: a clip with a seat height is lifted so that its seat plane
/// meets the individual's seat; any other stands at the foot point. seatHeightMetres is the
/// height of the seat's plane above the foot point, heightScale the individual's.
[[nodiscard]] float seatLift(const Clip& clip, float seatHeightMetres, float heightScale);

} // namespace crowd::model
