// SPDX-License-Identifier: MIT
#include "widgets/viewport/FrameStatistics.h"

#include <algorithm>

namespace crowd::widgets {

void FrameTimes::add(double milliseconds)
{
    m_times[m_next] = milliseconds;
    m_next = (m_next + 1) % m_times.size();
    m_count = std::min(m_count + 1, m_times.size());
}

double FrameTimes::median() const
{
    if (m_count == 0) {
        return 0.0;
    }
    std::array<double, 32> sorted = m_times;
    const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(m_count);
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(m_count / 2);
    std::nth_element(sorted.begin(), middle, end);
    return *middle;
}

} // namespace crowd::widgets
