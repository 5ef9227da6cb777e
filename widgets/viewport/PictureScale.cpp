// SPDX-License-Identifier: MIT
#include "widgets/viewport/PictureScale.h"

#include <algorithm>
#include <cmath>

namespace crowd::widgets {

namespace {

constexpr double kGoalMs = 33.0;
constexpr double kSlack = 0.85;  ///< of the goal, for a step back up
constexpr double kGrowth = 1.6;  ///< a picture takes longer by this power of its share, at most
constexpr double kTooSlow = 2.5; ///< times the goal: two steps at once

} // namespace

void PictureScale::note(double milliseconds)
{
    m_times[m_count] = milliseconds;
    if (++m_count < m_times.size()) {
        return;
    }
    std::ranges::sort(m_times);
    const double usual = m_times[m_times.size() / 2];
    m_count = 0;
    if (usual > kGoalMs && m_step + 1 < kShares.size()) {
        m_step = std::min(m_step + (usual > kTooSlow * kGoalMs ? 2 : 1), kShares.size() - 1);
    } else if (m_step > 0 &&
               usual * std::pow(kShares[m_step - 1] / share(), kGrowth) < kSlack * kGoalMs) {
        --m_step;
    }
}

void PictureScale::forget()
{
    m_step = 0;
    m_count = 0;
}

} // namespace crowd::widgets
