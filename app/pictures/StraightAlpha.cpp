// SPDX-License-Identifier: MIT
#include "app/pictures/StraightAlpha.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "model/base/Color.h"

namespace crowd::app {

namespace {

std::uint8_t unmultiplied(std::uint8_t encoded, std::uint8_t alpha)
{
    constexpr float kMost = 255.0F;
    const float light = model::linearFromSrgb(static_cast<float>(encoded) / kMost);
    const float own = std::min(1.0F, light * kMost / static_cast<float>(alpha));
    return static_cast<std::uint8_t>(std::lround(model::srgbFromLinear(own) * kMost));
}

} // namespace

void straightenAlpha(std::span<std::uint8_t> rgba)
{
    for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
        const std::uint8_t alpha = rgba[i + 3];
        if (alpha == 0 || alpha == 255) {
            continue;
        }
        for (std::size_t channel = 0; channel < 3; ++channel) {
            rgba[i + channel] = unmultiplied(rgba[i + channel], alpha);
        }
    }
}

} // namespace crowd::app
