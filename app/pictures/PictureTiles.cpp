// SPDX-License-Identifier: MIT
#include "app/pictures/PictureTiles.h"

#include <algorithm>
#include <cstddef>

#include <glm/common.hpp>

namespace crowd::app {

namespace {

/// As far as any pixel reads (occlusion.frag), in steps of the patterns.
constexpr int kRim = 8 * kTileStep;

PictureTile tileAt(glm::ivec2 picture, glm::ivec2 corner, glm::ivec2 size)
{
    PictureTile tile{corner, size};
    tile.drawnCorner = glm::max(corner - kRim, glm::ivec2(0));
    tile.drawnSize = glm::min(corner + size + kRim, picture) - tile.drawnCorner;
    return tile;
}

} // namespace

std::vector<TileRow> tilesOf(glm::ivec2 picture, int side)
{
    if (picture.x <= 2 * side && picture.y <= 2 * side) {
        return {{{{0, 0}, picture, {0, 0}, picture}}};
    }
    std::vector<TileRow> rows;
    // Patterns begin at the bottom, as OpenGL counts: what is left over is at the top.
    int top = 0;
    int bottom = (picture.y - 1) % side + 1;
    while (top < picture.y) {
        TileRow& row = rows.emplace_back();
        for (int left = 0; left < picture.x; left += side) {
            const glm::ivec2 size(std::min(side, picture.x - left), bottom - top);
            row.push_back(tileAt(picture, {left, top}, size));
        }
        top = bottom;
        bottom += side;
    }
    return rows;
}

void copyTile(const PictureTile& tile, std::span<const std::uint8_t> drawn,
              std::span<std::uint8_t> rows, int width)
{
    const glm::ivec2 inside = tile.corner - tile.drawnCorner;
    const std::size_t pixelBytes = drawn.size() / (static_cast<std::size_t>(tile.drawnSize.x) *
                                                   static_cast<std::size_t>(tile.drawnSize.y));
    const std::size_t bytes = static_cast<std::size_t>(tile.size.x) * pixelBytes;
    for (int y = 0; y < tile.size.y; ++y) {
        const int line = inside.y + y;
        const auto from =
            (static_cast<std::size_t>(line) * static_cast<std::size_t>(tile.drawnSize.x) +
             static_cast<std::size_t>(inside.x)) *
            pixelBytes;
        const auto to = (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(tile.corner.x)) *
                        pixelBytes;
        std::ranges::copy(drawn.subspan(from, bytes), rows.subspan(to).begin());
    }
}

} // namespace crowd::app
