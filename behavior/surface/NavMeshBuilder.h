// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <recastnavigation/DetourNavMesh.h>

#include "behavior/surface/SurfaceTiles.h"
#include "behavior/surface/TileBuilder.h"

namespace crowd::behavior {

using NavMesh = std::unique_ptr<dtNavMesh, Freed<dtNavMesh, dtFreeNavMesh>>;

/// What a surface is asked through, and what it was made of.
struct BuiltMesh
{
    NavMesh mesh; ///< none: cancelled, out of memory, or there is nothing to walk on
    float cellHeight = 0.0F;
};

/// Makes a mesh to ask for ways from triangles: tile by tile, on all cores, the same for any number
/// of them. Metres.
[[nodiscard]] BuiltMesh buildNavMesh(const TriangleSoup& soup, const SurfacePlan& plan,
                                     WalkSurface::Progress& progress);

} // namespace crowd::behavior
