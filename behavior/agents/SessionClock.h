// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

namespace crowd::behavior {

/// Steps of a session and the time that they stand for.
struct SessionClock
{
    std::uint64_t steps = 0;
    std::uint32_t stepsPerSecond = 30;
    float stepSeconds = 1.0F / 30.0F;
    double start = 0.0; ///< the transport's time when the session began, seconds

    static SessionClock withSteps(std::uint32_t perSecond)
    {
        return {0, perSecond, 1.0F / static_cast<float>(perSecond), 0.0};
    }
    [[nodiscard]] double seconds() const
    {
        return start + static_cast<double>(steps) / stepsPerSecond;
    }
    /// What is covered in one step of a share that is covered in 1/30 s, so that easing looks the
    /// same at any length of a step.
    [[nodiscard]] float shareInStep(float share) const
    {
        return stepsPerSecond == 30 ? share : 1.0F - std::pow(1.0F - share, 30.0F * stepSeconds);
    }
};

} // namespace crowd::behavior
