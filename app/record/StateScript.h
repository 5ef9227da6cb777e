// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/scene/Scene.h"

namespace crowd::app {

/// Lines, without indent, that make the states of `after` of those before: kept, renamed, removed,
/// arranged, each by its name; where that does not come to the same, as their text. `after` is the
/// scene as it is then.
[[nodiscard]] std::vector<std::string> stateLines(const std::vector<model::State>& before,
                                                  const model::Scene& after);

} // namespace crowd::app
