// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/scene/Take.h"

namespace crowd::app {

/// Lines, without indent, that make the takes of `after` of those before: removed, renamed, added
/// from their files, shown. One whose motion is not there can only be told of.
[[nodiscard]] std::vector<std::string> takeLines(const model::Takes& before,
                                                 const model::Takes& after);

} // namespace crowd::app
