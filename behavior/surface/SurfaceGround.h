// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "behavior/surface/TriangleSoup.h"

struct rcPolyMesh;

namespace crowd::behavior {

/// One for each polygon: whether it belongs to the ground. That is what is linked to the open
/// ground about the stages, and floors: large parts of the lower half of the stages that nothing
/// leads to. Roofs, crowns of trees and basins are not, nor is the inside of a solid body, such as
/// a house that is only walls and roof as seen from outside. World frame, metres.
[[nodiscard]] std::vector<char> groundOf(const rcPolyMesh& mesh, const TriangleSoup& soup);

} // namespace crowd::behavior
