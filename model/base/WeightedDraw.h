// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace crowd::model {

/// Which of some items a share, [0, 1), of the sum of their weights falls on; the last one where
/// rounding leaves none, or nothing weighs anything. There must be one at least.
template<class Items, class WeightOf>
[[nodiscard]] std::size_t weightedIndex(const Items& items, float share, const WeightOf& weightOf)
{
    float total = 0.0F;
    for (const auto& item : items) {
        total += weightOf(item);
    }
    float left = total * share;
    std::size_t index = 0;
    for (const auto& item : items) {
        left -= weightOf(item);
        if (left < 0.0F) {
            return index;
        }
        ++index;
    }
    return index - 1;
}

} // namespace crowd::model
