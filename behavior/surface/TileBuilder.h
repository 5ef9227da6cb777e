// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <recastnavigation/DetourAlloc.h>
#include <recastnavigation/Recast.h>

#include "behavior/surface/NarrowWays.h"
#include "behavior/surface/SurfaceTiles.h"
#include "behavior/surface/WalkSurface.h"

namespace crowd::behavior {

/// Deletes with a function of Recast's.
template<class T, void (*Free)(T*)>
struct Freed
{
    void operator()(T* object) const { Free(object); }
};

inline void freeTile(unsigned char* data)
{
    dtFree(data);
}

/// A tile as Detour keeps it; nothing where nothing can be walked on.
struct TileData
{
    std::unique_ptr<unsigned char, Freed<unsigned char, freeTile>> bytes;
    int size = 0;
    int polygons = 0;
};

/// Makes one tile of a surface from triangles, with Recast: steps, each of which may fail. Keeps
/// references to all that it is given. Metres; any one thread.
class TileBuilder
{
public:
    TileBuilder(const TriangleSoup& soup, const SurfacePlan& plan, const SurfaceTiles& tiles,
                std::size_t tile, const WalkSurface::Progress& progress);

    /// False: cancelled, out of memory, or there is more in it than Recast can count.
    [[nodiscard]] bool run(TileData& into);

private:
    using HeightField = std::unique_ptr<rcHeightfield, Freed<rcHeightfield, rcFreeHeightField>>;
    using Compact = std::unique_ptr<rcCompactHeightfield,
                                    Freed<rcCompactHeightfield, rcFreeCompactHeightfield>>;
    using Mesh = std::unique_ptr<rcPolyMesh, Freed<rcPolyMesh, rcFreePolyMesh>>;
    using Detail = std::unique_ptr<rcPolyMeshDetail, Freed<rcPolyMeshDetail, rcFreePolyMeshDetail>>;

    [[nodiscard]] bool goesOn() const { return !m_progress.isOver(); }
    bool rasterize();
    bool filter();
    void mark(const model::Place& place, float margin, unsigned char area);
    void markDisc(const model::Place& place, float margin, unsigned char area);
    void markStrip(const glm::vec3& from, const glm::vec3& to, float half, unsigned char area);
    void markEnclosed(std::span<const glm::vec3> corners, unsigned char area);
    void markAreas();
    bool outline();
    bool assemble(TileData& into);

    const TriangleSoup& m_soup;
    const SurfacePlan& m_plan;
    const SurfaceTiles& m_tiles;
    std::size_t m_tile;
    rcConfig m_config;
    BodyCells m_body;
    const WalkSurface::Progress& m_progress;
    rcContext m_context{false};
    HeightField m_field;
    Compact m_compact;
    Mesh m_mesh;
    Detail m_detail;
};

} // namespace crowd::behavior
