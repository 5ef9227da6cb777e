// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace crowd::behavior {
class WalkSurface;
}

namespace crowd::model {
struct Place;
}

namespace crowd::widgets {

/// Corners from place to place; world frame, metres.
using WayCorners = std::vector<glm::vec3>;

/// How people get from one place to another where something stands between: as those in the middle
/// of the flow go and, if those at its edges pass by on the other side, as these do. Empty where
/// the middle is free, or nobody knows yet (no surface).
[[nodiscard]] std::vector<WayCorners> waysAround(const behavior::WalkSurface* surface,
                                                 const model::Place& from, const model::Place& to);

} // namespace crowd::widgets
