// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/base/Bounds.h"

struct rcPolyMesh;

namespace crowd::behavior {

/// One for each polygon: whether it belongs to the ground. That is what is linked to the open
/// ground about the stages, and floors: large parts of the lower half of the stages that nothing
/// leads to. Roofs, crowns of trees and basins are not. World frame, metres.
[[nodiscard]] std::vector<char> groundOf(const rcPolyMesh& mesh, const model::Bounds& stages);

} // namespace crowd::behavior
