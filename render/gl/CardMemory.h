// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

/// What OpenGL objects of this process take on the graphics card, as far as it is asked for here:
/// buffers, textures with their mipmaps, what is drawn into. A driver may need more. Any thread.
namespace crowd::render::card_memory {

/// Bytes taken now.
[[nodiscard]] std::int64_t bytes();

/// From now on as on a card that has no more: what would go beyond is refused as the driver would.
/// None: as much as the driver gives.
void limitTo(std::int64_t bytes);
inline constexpr std::int64_t kNoLimit = INT64_MAX;

/// False: the limit does not allow it, and nothing was taken.
[[nodiscard]] bool take(std::size_t bytes);
void giveBack(std::size_t bytes);

/// Whether something was refused on this thread since it was asked last, by the limit or by the
/// driver; its context is current.
[[nodiscard]] bool wasShort();

} // namespace crowd::render::card_memory
