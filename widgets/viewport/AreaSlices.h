// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "widgets/viewport/GroundSheets.h"

namespace crowd::widgets {

/// What corners enclose, cut from north to south into pieces without bends, so that each can be
/// laid on the ground. Metres, world frame; any number of corners, sides may cross.
[[nodiscard]] std::vector<BandShape> slicesOf(std::span<const glm::vec3> corners);

} // namespace crowd::widgets
