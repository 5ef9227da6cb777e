// SPDX-License-Identifier: MIT
#include "model/scene/CrowdFrame.h"

#include <algorithm>
#include <cmath>

namespace crowd::model {

float shownPhase(const Clip& clip, float phase, float playbackSpeed, double seconds)
{
    if (clip.seconds <= 0.0F) {
        return 0.0F;
    }
    const double place = static_cast<double>(phase) + seconds * static_cast<double>(playbackSpeed) /
                                                          static_cast<double>(clip.seconds);
    if (!clip.loop) {
        return static_cast<float>(std::clamp(place, 0.0, 1.0));
    }
    const double wrapped = place - std::floor(place);
    return std::min(static_cast<float>(wrapped), 0.99999994F);
}

float seatLift(const Clip& clip, float seatHeightMetres, float heightScale)
{
    return clip.seatHeight ? seatHeightMetres - *clip.seatHeight * heightScale : 0.0F;
}

} // namespace crowd::model
