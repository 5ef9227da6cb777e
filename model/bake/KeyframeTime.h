// SPDX-License-Identifier: MIT
#pragma once

#include "model/template/Template.h"

namespace crowd::model {

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
