// SPDX-License-Identifier: MIT
#include "behavior/session/Gait.h"

#include <algorithm>
#include <cmath>

#include "model/brush/ClipChoice.h"

namespace crowd::behavior {

namespace {

constexpr float kStandBelow = 0.2F; ///< m/s
constexpr float kHysteresis = 0.15F;

} // namespace

GaitTable::GaitTable(const model::TemplateEntry& entry)
{
    if (!entry.asset) {
        return;
    }
    const auto standing = static_cast<std::size_t>(entry.asset->defaultClip);
    for (std::size_t i = 0; i < entry.clipNames.size(); ++i) {
        const int index = entry.asset->clipIndex(entry.clipNames[i]);
        if (index < 0) {
            continue;
        }
        const auto clip = static_cast<std::size_t>(index);
        const bool moves = model::movesOverGround(entry, i, clip);
        if (moves || clip == standing) {
            m_gaits.push_back({static_cast<std::uint16_t>(i),
                               moves ? model::groundSpeed(entry, i, clip) : 0.0F,
                               entry.asset->clips[clip].seconds});
        }
    }
    std::ranges::stable_sort(m_gaits, {}, &Gait::metresPerSecond);
    if (m_gaits.empty() || m_gaits.front().metresPerSecond > 0.0F) {
        m_gaits.clear(); // nothing to stand with
    }
}

bool GaitTable::isMover(std::size_t clip) const
{
    return std::ranges::any_of(m_gaits, [clip](const Gait& gait) {
        return gait.clip == clip && gait.metresPerSecond > 0.0F;
    });
}

std::size_t GaitTable::gaitOf(std::size_t clip) const
{
    const auto found = std::ranges::find(m_gaits, clip, &Gait::clip);
    return found == m_gaits.end() || found->metresPerSecond <= 0.0F
               ? 0
               : static_cast<std::size_t>(found - m_gaits.begin());
}

std::size_t GaitTable::choose(std::size_t present, float metresPerSecond, std::size_t style) const
{
    if (style != 0) {
        // One clip at every speed; standing begins and ends as ever.
        const float border = kStandBelow * (present == 0 ? 1.0F + kHysteresis : 1.0F - kHysteresis);
        return metresPerSecond > border ? style : 0;
    }
    const auto border = [this](std::size_t upper) {
        return upper == 1
                   ? kStandBelow
                   : std::sqrt(m_gaits[upper - 1].metresPerSecond * m_gaits[upper].metresPerSecond);
    };
    std::size_t gait = std::min(present, m_gaits.size() - 1);
    while (gait + 1 < m_gaits.size() && metresPerSecond > border(gait + 1) * (1.0F + kHysteresis)) {
        ++gait;
    }
    while (gait > 0 && metresPerSecond < border(gait) * (1.0F - kHysteresis)) {
        --gait;
    }
    return gait;
}

float GaitTable::playback(const Gait& gait, float metresPerSecond, float height)
{
    return gait.metresPerSecond > 0.0F
               ? metresPerSecond / (gait.metresPerSecond * std::max(height, 0.05F))
               : 1.0F;
}

} // namespace crowd::behavior
