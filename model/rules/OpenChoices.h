// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/rules/Rule.h"
#include "model/scene/Path.h"

/// Rules that belong together name the same path, and wait together for its choice.
namespace crowd::model {

/// Where the artist has just chosen a path in a rule that had none (`before`, now `after`), the
/// rules that still wait for one get it too; those that begin at a place not chosen yet
/// get the path's first one. The number of rules that were changed.
int fillOpenChoices(std::vector<Rule>& rules, const Rule& before, const Rule& after,
                    const std::vector<Path>& paths);

} // namespace crowd::model
