// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace crowd::behavior {

/// A clip and the place in it. Seconds; places count loops, 0..1.
struct ClipPlace
{
    std::uint16_t clip = 0; ///< as the clip column counts
    bool isLooped = true;
    float rate = 1.0F;        ///< playback speed
    float clipSeconds = 0.0F; ///< 0: a pose
    double place = 0.0;

    /// Of one that goes by the clock, whose `place` is that at time 0.
    [[nodiscard]] double placeAt(double seconds) const
    {
        return clipSeconds > 0.0F
                   ? place + seconds * static_cast<double>(rate) / static_cast<double>(clipSeconds)
                   : place;
    }
};

/// Bits of MotionState::flags and SessionPose::flags.
enum PoseFlag : std::uint8_t {
    kPoseLive = 1,   ///< the session moves this agent; else it is as the scene says
    kPoseLooped = 2, ///< its clip
    kPoseGone = 4,   ///< it has left the scene
    kPoseClock = 8,  ///< its clip goes by the clock: the place is that at time 0
    kPoseFading = 16 ///< a former clip still fades out
};

/// Seconds of a fade from one clip to the next.
inline constexpr double kFadeSeconds = 0.25;

} // namespace crowd::behavior
