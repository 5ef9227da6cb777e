// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <recastnavigation/DetourNavMeshQuery.h>

#include "behavior/crowd/WallField.h"
#include "behavior/surface/NavMeshBuilder.h"
#include "behavior/surface/SurfaceGround.h"
#include "model/base/Bounds.h"
#include "model/pick/StageRays.h"

namespace crowd::behavior {

/// What a WalkSurface holds and its parts ask: where people stand (SurfaceFooting), which ways they
/// take (SurfaceWays). Immutable once built. World frame, metres.
struct SurfaceData
{
    NavMesh mesh;
    std::vector<Wall> walls;
    std::size_t polygons = 0;
    SurfaceGround ground;
    model::StageRays rays; ///< the stages as they stood
    model::Bounds covered; ///< beyond is open ground
    float cellHeight = 0.0F;
    float radius = 0.35F; ///< of bodies
    float climb = 0.45F;
    float height = 1.8F;
    float slopeCosine = 0.77F; ///< of the steepest
    dtQueryFilter filter;      ///< for ways
    dtQueryFilter everything;  ///< also where nobody is to walk

    /// One for each thread that asks.
    [[nodiscard]] dtNavMeshQuery* query() const
    {
        constexpr int kMaxNodes = 8192; // of a search
        using Query = std::unique_ptr<dtNavMeshQuery, Freed<dtNavMeshQuery, dtFreeNavMeshQuery>>;
        thread_local Query cached;
        thread_local const dtNavMesh* cachedFor = nullptr;
        if (cachedFor != mesh.get() || !cached) {
            cached.reset(dtAllocNavMeshQuery());
            cachedFor = cached && dtStatusSucceed(cached->init(mesh.get(), kMaxNodes)) ? mesh.get()
                                                                                       : nullptr;
        }
        return cachedFor == nullptr ? nullptr : cached.get();
    }
};

} // namespace crowd::behavior
