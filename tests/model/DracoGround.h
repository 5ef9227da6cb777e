// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

/// The ground that pack_ground compresses: a grid of squares of one metre, two triangles each.
namespace draco_ground {

inline constexpr int kSide = 6; ///< squares along a side
inline constexpr int kPoints = (kSide + 1) * (kSide + 1);
inline constexpr int kCorners = kSide * kSide * 6;

inline float height(int x, int z)
{
    return std::sin(static_cast<float>(x * z));
}

} // namespace draco_ground
