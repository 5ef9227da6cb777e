// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "render/RenderInput.h"

namespace crowd::widgets {

/// How the last pictures went, for the status bar.
struct FrameStatistics
{
    render::RenderStatistics render;
    double frameMs = 0.0;         ///< from the start of drawing to the swap, median of the last 32
    double framesPerSecond = 0.0; ///< while animating; 0 when the picture stands still
};

/// Median of the last frame times. No allocation after construction.
class FrameTimes
{
public:
    void add(double milliseconds);
    [[nodiscard]] double median() const; ///< 0 when there are none

private:
    std::array<double, 32> m_times{};
    std::size_t m_next = 0;
    std::size_t m_count = 0;
};

} // namespace crowd::widgets
