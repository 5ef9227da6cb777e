// SPDX-License-Identifier: MIT
#pragma once

#include "model/template/Template.h"

namespace crowd::model {

/// When keyframe k of a clip is sampled, in seconds after the clip's start: k/32 s for all but the
/// last, which is the extra one at the clip's end. Where the duration is no multiple of 1/32 s the
/// last interval is therefore between half and one and a half times as long as the others.
[[nodiscard]] float keyframeSeconds(const Clip& clip, int keyframe);

/// Two neighbouring keyframes and the share of the second.
struct KeyframePlace
{
    int first = 0;
    int second = 0;
    float blend = 0.0F; ///< 0..1
};
/// Where a phase (0..1 of the clip, as shownPhase gives it) lies between the keyframes. The end of
/// a loop is its own keyframe, so nothing wraps.
[[nodiscard]] KeyframePlace keyframePlace(const Clip& clip, float phase);

} // namespace crowd::model
