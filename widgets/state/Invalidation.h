// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/scene/Scene.h"
#include "model/scene/SceneChange.h"
#include "model/scene/Timeline.h"

/// Which edits of a scene make another of what a run of it has done already.
namespace crowd::widgets {

/// Whether people of the scene, which has been edited so, do something else from then on: how they
/// look is the same at all times, and what only rules and marks ask for counts where there are
/// such.
[[nodiscard]] bool changesMotion(const model::SceneChange& change, const model::Scene& scene);

/// The earliest time from `since` on, seconds, at which another thing happens in one timeline than
/// in the other; nothing: there is none.
[[nodiscard]] std::optional<double> firstDifference(const model::Timeline& before,
                                                    const model::Timeline& after, double since);

} // namespace crowd::widgets
