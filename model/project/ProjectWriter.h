// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/base/Result.h"
#include "model/scene/Scene.h"

namespace crowd::model {

/// The project file's bytes: a JSON object with small members first and the individuals as a table,
/// one a line, columns that are default for everybody left out. The same scene always gives the
/// same bytes. Paths are written as they stand in the entries. Fails when a value is not finite,
/// naming the individual and the column.
[[nodiscard]] Result<std::string> projectToText(const Scene& scene);

} // namespace crowd::model
