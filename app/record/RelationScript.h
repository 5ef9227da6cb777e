// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/scene/Scene.h"

namespace crowd::app {

/// Lines, without indent, that make the relations of `after`: one call for each kind of those that
/// go and of those that come. Relations of people who go, go with them.
[[nodiscard]] std::vector<std::string> relationLines(const model::RelationDelta& changed,
                                                     const model::Scene& after);

} // namespace crowd::app
