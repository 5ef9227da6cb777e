// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "app/pictures/ExrFile.h"

namespace crowd::app {

/// A pass as whole numbers of 16 bits, for programs that read no OpenEXR: rows from the top.
struct PassSamples
{
    int channels = 1; ///< 1 or 3
    std::vector<std::uint16_t> values;
};

/// Centimetres; 65535: farther than 655 m, or nothing.
[[nodiscard]] PassSamples depthSamples(const ExrLayer& layer);
/// Of -1 to 1, 0 to 65535; nothing: 0, 0, 0.
[[nodiscard]] PassSamples normalSamples(const ExrLayer& layer);
/// Centimetres around 32768: within 327 m of the origin; nothing: 0, 0, 0.
[[nodiscard]] PassSamples positionSamples(const ExrLayer& layer);
/// Sixty-fourths of a pixel around 32768, right and up; the third channel is 0.
[[nodiscard]] PassSamples motionSamples(const ExrLayer& layer);
/// Red is the upper half of the number, green the lower.
[[nodiscard]] PassSamples numberSamples(const ExrLayer& layer);

} // namespace crowd::app
