// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/scene/Scene.h"

namespace crowd::app {

/// A field of `count` people of the templates in turn, 30 to 90 pixels high in a picture of 720
/// rows, or where it is far none above 30: rows that fill the view of the scene's camera "bench",
/// at various clips, phases, tints, heights.
[[nodiscard]] model::Scene makeBenchField(const std::vector<model::TemplatePtr>& assets, int count,
                                          bool isFar = false);

/// Seats copies of the scene's people on free seats, in order, until there are `count` or no seat
/// is left.
void seatMore(model::Scene& scene, std::size_t count);

/// Keeps the first `count` people in the order of a fixed shuffle.
void keepPeople(model::Scene& scene, std::size_t count);

} // namespace crowd::app
