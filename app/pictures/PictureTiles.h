// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace crowd::app {

/// A rectangle of a picture that is drawn by itself: pixels, from the top left.
struct PictureTile
{
    glm::ivec2 corner{0}; ///< what is kept
    glm::ivec2 size{0};
    glm::ivec2 drawnCorner{0}; ///< with a rim, which the picture's lines and dark corners read
    glm::ivec2 drawnSize{0};
};

/// Some tiles side by side that are as wide as the picture.
using TileRow = std::vector<PictureTile>;

/// What a tile's side is a multiple of: patterns of the picture (of its occlusion) go on across
/// tiles.
inline constexpr int kTileStep = 24;

/// From the top; a single tile without a rim where both sides are at most twice `side`, which is a
/// multiple of kTileStep.
[[nodiscard]] std::vector<TileRow> tilesOf(glm::ivec2 picture, int side);

/// Puts what is kept of a drawn tile (rows from the top, of pixels of any size) where it is among
/// rows of the picture, `width` pixels each, the first of them that of the tile.
void copyTile(const PictureTile& tile, std::span<const std::uint8_t> drawn,
              std::span<std::uint8_t> rows, int width);

} // namespace crowd::app
