// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "render/RenderInput.h"

namespace crowd::render {

/// Which level a projected height gets, with the thresholds and their hysteresis laid out in a
/// table so that choosing takes no branch. Thresholds fall from level to level.
class LevelChoice
{
public:
    static constexpr std::size_t kNone = kDrawnLevels; ///< no last level

    explicit LevelChoice(const LevelThresholds& thresholds)
    {
        for (std::size_t last = 0; last < m_below.size(); ++last) {
            const float hysteresis = last == kNone ? 0.0F : thresholds.hysteresis;
            // Already coarser: it takes more to come back. Still finer: less to stay.
            for (std::size_t i = 0; i < thresholds.pixels.size(); ++i) {
                m_below[last][i] =
                    thresholds.pixels[i] * (last > i ? 1.0F + hysteresis : 1.0F - hysteresis);
            }
            m_belowImpostor[last] =
                thresholds.impostorPixels *
                (last >= kImpostorLevel ? 1.0F + hysteresis : 1.0F - hysteresis);
        }
    }

    /// `last` may be any number above kNone, too; `coarsest` is the last level there is. Not of
    /// impostors.
    [[nodiscard]] std::int32_t level(float pixels, std::size_t last, std::int32_t coarsest) const
    {
        const auto& below = m_below[last < kNone ? last : kNone];
        std::int32_t level = 0;
        for (const float threshold : below) {
            level += pixels < threshold ? 1 : 0;
        }
        return level < coarsest ? level : coarsest;
    }

    [[nodiscard]] bool isImpostorSmall(float pixels, std::size_t last) const
    {
        return pixels < m_belowImpostor[last < kNone ? last : kNone];
    }

private:
    /// By last level: pixels below which the level after the second index is taken.
    std::array<std::array<float, model::kMaxLevels - 1>, kDrawnLevels + 1> m_below{};
    std::array<float, kDrawnLevels + 1> m_belowImpostor{};
};

} // namespace crowd::render
