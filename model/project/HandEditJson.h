// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/base/Result.h"
#include "model/scene/HandEdit.h"

/// What is done by hand to a take's people, as JSON beside files: for scripts.
namespace crowd::model {

/// A list of objects, without what an edit has by default.
[[nodiscard]] std::string handEditsText(const std::vector<HandEdit>& edits);
/// People in any order. Error: it is no such list; names the first thing that is wrong, with its
/// place.
[[nodiscard]] Result<std::vector<HandEdit>> readHandEdits(const std::string& text);

} // namespace crowd::model
