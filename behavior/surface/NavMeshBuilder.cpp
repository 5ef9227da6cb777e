// SPDX-License-Identifier: MIT
#include "behavior/surface/NavMeshBuilder.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <vector>

#include "model/base/Parallel.h"

namespace crowd::behavior {

namespace {

constexpr float kMostCoarser = 8.0F; ///< than the first try
constexpr int kReferenceBits = 22;   ///< of a polygon's reference, for its tile and its number

/// Empty: one of them failed, or the building was cancelled.
std::vector<TileData> buildTiles(const TriangleSoup& soup, const SurfacePlan& plan,
                                 const SurfaceTiles& tiles, WalkSurface::Progress& progress)
{
    std::vector<TileData> built(tiles.count());
    std::atomic<bool> isFailed{false};
    std::atomic<std::size_t> count{0};
    model::parallelFor(built.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tile = begin; tile < end; ++tile) {
            if (isFailed || !TileBuilder(soup, plan, tiles, tile, progress).run(built[tile])) {
                isFailed = true;
                return;
            }
            progress.done = 0.9F * static_cast<float>(++count) / static_cast<float>(built.size());
        }
    });
    if (isFailed) {
        built.clear();
    }
    return built;
}

int bitsFor(std::size_t count)
{
    return static_cast<int>(std::bit_width(std::bit_ceil(std::max<std::size_t>(count, 1)) - 1));
}

NavMesh assembled(std::vector<TileData> built, const TriangleSoup& soup, const SurfaceTiles& tiles)
{
    int most = 0;
    std::size_t filled = 0;
    for (const TileData& tile : built) {
        most = std::max(most, tile.polygons);
        filled += tile.polygons > 0 ? 1 : 0;
    }
    if (filled == 0 || bitsFor(filled) + bitsFor(static_cast<std::size_t>(most)) > kReferenceBits) {
        return nullptr;
    }
    dtNavMeshParams params{};
    params.orig[0] = tiles.origin.x;
    params.orig[1] = soup.bounds.low.y;
    params.orig[2] = tiles.origin.y;
    params.tileWidth = params.tileHeight = tiles.side;
    params.maxTiles = static_cast<int>(filled);
    params.maxPolys = 1 << bitsFor(static_cast<std::size_t>(most));
    NavMesh mesh(dtAllocNavMesh());
    if (!mesh || dtStatusFailed(mesh->init(&params))) {
        return nullptr;
    }
    for (TileData& tile : built) {
        if (tile.polygons == 0) {
            continue;
        }
        if (dtStatusFailed(
                mesh->addTile(tile.bytes.get(), tile.size, DT_TILE_FREE_DATA, 0, nullptr))) {
            return nullptr;
        }
        (void)tile.bytes.release(); // it is the mesh's
    }
    return mesh;
}

} // namespace

BuiltMesh buildNavMesh(const TriangleSoup& soup, const SurfacePlan& plan,
                       WalkSurface::Progress& progress)
{
    BuiltMesh built;
    // Too much for a tile to count: wider cells see less of it.
    for (float coarser = 1.0F; !built.mesh && coarser <= kMostCoarser && !progress.isOver();
         coarser *= 2.0F) {
        const SurfaceTiles tiles = SurfaceTiles::of(soup, plan, coarser);
        std::vector<TileData> pieces = buildTiles(soup, plan, tiles, progress);
        const bool isNothing =
            !pieces.empty() &&
            std::ranges::all_of(pieces, [](const TileData& tile) { return tile.polygons == 0; });
        if (isNothing || progress.isOver()) {
            return {};
        }
        built = {assembled(std::move(pieces), soup, tiles), tiles.cellHeight};
    }
    return built;
}

} // namespace crowd::behavior
