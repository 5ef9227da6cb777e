// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "model/base/Result.h"

namespace crowd::app {

/// How long all built-in characters take to be read: meshes, levels, clips, textures, without
/// baking. The floor is what the same files need at least in the same run: reading the bytes,
/// parsing their JSON and decoding their pictures.
struct CastTimes
{
    std::size_t templates = 0;
    std::size_t bytes = 0;
    double loadMs = 0.0;  ///< median of the rounds
    double floorMs = 0.0; ///< median of the rounds
};

/// One file after the other, in one thread; needs no display.
[[nodiscard]] model::Result<CastTimes> timeCast(int rounds);

} // namespace crowd::app
