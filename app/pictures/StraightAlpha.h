// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

namespace crowd::app {

/// Pictures as the renderer leaves them hold light times alpha, encoded as sRGB; most files want
/// the colour without: divides it out in place, RGBA8.
void straightenAlpha(std::span<std::uint8_t> rgba);
/// And back.
void multiplyAlpha(std::span<std::uint8_t> rgba);

} // namespace crowd::app
