// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "behavior/crowd/Body.h"
#include "model/scene/Path.h"

namespace crowd::behavior {

/// What places do to those who walk near them: attractors and repellers bend the velocity that
/// bodies desire. Returns the agents who have reached an exit, each once, in the order in which
/// they are to leave. `isGone` by agent; whoever is gone is left alone.
[[nodiscard]] std::vector<std::uint32_t> applyPlaceEffects(std::span<const model::Place> places,
                                                           std::span<Body> bodies,
                                                           std::span<const std::uint8_t> isGone);

} // namespace crowd::behavior
