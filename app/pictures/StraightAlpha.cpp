// SPDX-License-Identifier: MIT
#include "app/pictures/StraightAlpha.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "model/base/Color.h"

namespace crowd::app {

namespace {

constexpr float kMost = 255.0F;

std::uint8_t withLightTimes(std::uint8_t encoded, float factor)
{
    const float light = model::linearFromSrgb(static_cast<float>(encoded) / kMost);
    const float other = std::min(1.0F, light * factor);
    return static_cast<std::uint8_t>(std::lround(model::srgbFromLinear(other) * kMost));
}

/// factorOf(alpha), 0 to 1; of what is seen through in part.
template<class Factor>
void scaleLight(std::span<std::uint8_t> rgba, const Factor& factorOf)
{
    for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
        const std::uint8_t alpha = rgba[i + 3];
        if (alpha == 0 || alpha == 255) {
            continue;
        }
        const float factor = factorOf(static_cast<float>(alpha) / kMost);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            rgba[i + channel] = withLightTimes(rgba[i + channel], factor);
        }
    }
}

} // namespace

void straightenAlpha(std::span<std::uint8_t> rgba)
{
    scaleLight(rgba, [](float alpha) { return 1.0F / alpha; });
}

void multiplyAlpha(std::span<std::uint8_t> rgba)
{
    scaleLight(rgba, [](float alpha) { return alpha; });
    for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
        if (rgba[i + 3] == 0) {
            std::ranges::fill(rgba.subspan(i, 3), std::uint8_t{0});
        }
    }
}

} // namespace crowd::app
