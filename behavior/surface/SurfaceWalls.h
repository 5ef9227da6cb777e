// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "behavior/crowd/WallField.h"
#include "model/scene/Scene.h"

struct rcPolyMesh;

namespace crowd::behavior {

/// Edges of the polygons beyond which there is nothing, but for the open ground's. World frame,
/// metres.
[[nodiscard]] std::vector<Wall> wallsOf(const rcPolyMesh& mesh,
                                        const model::SurfaceSettings& settings);

} // namespace crowd::behavior
