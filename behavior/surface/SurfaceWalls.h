// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "behavior/crowd/WallField.h"
#include "model/base/Bounds.h"
#include "model/scene/Scene.h"

class dtNavMesh;

namespace crowd::behavior {

/// Edges of the polygons beyond which there is nothing, but for the open ground's about what is
/// covered. World frame, metres.
[[nodiscard]] std::vector<Wall> wallsOf(const dtNavMesh& mesh, const model::Bounds& covered,
                                        const model::SurfaceSettings& settings);

} // namespace crowd::behavior
