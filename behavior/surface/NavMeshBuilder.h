// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <utility>

#include <recastnavigation/DetourNavMesh.h>
#include <recastnavigation/Recast.h>

#include "behavior/surface/TriangleSoup.h"
#include "behavior/surface/WalkSurface.h"

namespace crowd::behavior {

/// Deletes with a function of Recast's.
template<class T, void (*Free)(T*)>
struct Freed
{
    void operator()(T* object) const { Free(object); }
};
using NavMesh = std::unique_ptr<dtNavMesh, Freed<dtNavMesh, dtFreeNavMesh>>;

/// Makes a mesh to ask for ways from triangles, with Recast: steps, each of which may fail. Keeps
/// references to all that it is given. Metres; any one thread.
class NavMeshBuilder
{
public:
    NavMeshBuilder(const TriangleSoup& soup, const SurfacePlan& plan,
                   WalkSurface::Progress& progress);

    /// False: cancelled, out of memory, or there is nothing to walk on.
    [[nodiscard]] bool run(const SurfaceSettings& settings);
    [[nodiscard]] NavMesh take() { return std::move(m_nav); }
    /// The polygons that it was made from.
    [[nodiscard]] const rcPolyMesh& mesh() const { return *m_mesh; }

private:
    using HeightField = std::unique_ptr<rcHeightfield, Freed<rcHeightfield, rcFreeHeightField>>;
    using Compact = std::unique_ptr<rcCompactHeightfield,
                                    Freed<rcCompactHeightfield, rcFreeCompactHeightfield>>;
    using Mesh = std::unique_ptr<rcPolyMesh, Freed<rcPolyMesh, rcFreePolyMesh>>;
    using Detail = std::unique_ptr<rcPolyMeshDetail, Freed<rcPolyMeshDetail, rcFreePolyMeshDetail>>;

    bool next(float done);
    bool rasterize();
    bool filter();
    void mark(const model::Place& place, float margin, unsigned char area);
    bool markAreas();
    bool outline();
    bool assemble(const SurfaceSettings& settings);

    const TriangleSoup& m_soup;
    std::span<const model::Place> m_areas;
    rcConfig m_config;
    WalkSurface::Progress& m_progress;
    rcContext m_context{false};
    HeightField m_field;
    Compact m_compact;
    Mesh m_mesh;
    Detail m_detail;
    NavMesh m_nav;
};

} // namespace crowd::behavior
