// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace crowd::model {

/// A tint of one slot: sRGB colour and the strength (0 none, 255 full) with which it multiplies the
/// base colour inside the slot's tint mask. Packed so that a column of tints is 4 bytes a row.
struct Tint
{
    std::uint8_t red = 255;
    std::uint8_t green = 255;
    std::uint8_t blue = 255;
    std::uint8_t strength = 0;

    friend bool operator==(const Tint&, const Tint&) = default;
};
static_assert(sizeof(Tint) == 4);

/// sRGB transfer function (IEC 61966-2-1), per channel, 0..1.
[[nodiscard]] float linearFromSrgb(float encoded);
[[nodiscard]] float srgbFromLinear(float linear);
[[nodiscard]] glm::vec3 linearFromSrgb(const glm::vec3& encoded);

} // namespace crowd::model
