// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "model/base/Result.h"
#include "model/scene/Scene.h"

namespace crowd::model {

/// Reads a project file's bytes. Assets are not loaded: entries have paths and names only.
/// Any JSON layout is accepted as long as "columns" stands before "rows". The message of a failure
/// names the line, or the row and its column; nothing is ever half-read or silently dropped.
[[nodiscard]] Result<Scene> projectFromText(std::string_view text);

} // namespace crowd::model
