// SPDX-License-Identifier: MIT
#include "render/passes/StillCasters.h"

#include <utility>

namespace crowd::render {

model::Result<bool> StillCasters::begin(ShadowTarget& target, int pixels,
                                        const PassContext& context,
                                        std::span<const glm::mat4> views,
                                        const DrawStages& drawStages)
{
    m_framesAtRest = 0;
    Still now{{views.begin(), views.end()}, pixels, {}};
    for (const model::StageEntry& entry : context.input.stages) {
        if (entry.asset) {
            now.stages.push_back({entry.asset, entry.worldFromStage()});
        }
    }
    const bool isStill = now == m_last;
    m_isKept = m_isKept && isStill;
    m_last = std::move(now);
    if (isStill && !m_isKept && m_kept.begin(pixels)) {
        if (auto drawn = drawStages(); !drawn) {
            return drawn.error();
        }
        m_isKept = true;
    }
    const bool isOffered = target.begin(pixels, m_isKept ? &m_kept : nullptr);
    if (isOffered && !m_isKept) {
        if (auto drawn = drawStages(); !drawn) {
            return drawn.error();
        }
    }
    return isOffered;
}

void StillCasters::rest()
{
    constexpr int kFramesBeforeForgetting = 60; // as stages go
    if (++m_framesAtRest > kFramesBeforeForgetting) {
        m_last = {};
        m_isKept = false;
    }
}

} // namespace crowd::render
