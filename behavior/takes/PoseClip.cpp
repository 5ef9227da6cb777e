// SPDX-License-Identifier: MIT
#include "behavior/takes/PoseClip.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace crowd::behavior {

std::size_t rowOfPerson(const SessionPose& pose, model::IndividualId id)
{
    const auto found = std::ranges::lower_bound(pose.ids, id);
    return found != pose.ids.end() && *found == id
               ? static_cast<std::size_t>(found - pose.ids.begin())
               : kNotInPose;
}

double wholeTurns(const ClipPlace& clip, double place)
{
    return clip.isLooped ? place - std::floor(place) : std::clamp(place, 0.0, 1.0);
}

ClipPlace clipOf(const SessionPose& pose, std::size_t row)
{
    return {pose.clips[row], (pose.flags[row] & kPoseLooped) != 0, pose.rates[row],
            pose.clipSeconds[row], static_cast<double>(pose.places[row])};
}

void putClip(SessionPose& pose, std::size_t row, const ClipPlace& clip)
{
    pose.clips[row] = clip.clip;
    pose.rates[row] = clip.rate;
    pose.clipSeconds[row] = clip.clipSeconds;
    pose.places[row] = static_cast<float>(clip.place);
    const unsigned others = pose.flags[row] & ~unsigned{kPoseLooped};
    pose.flags[row] =
        static_cast<std::uint8_t>(others | (clip.isLooped ? unsigned{kPoseLooped} : 0U));
}

} // namespace crowd::behavior
