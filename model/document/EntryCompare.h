// SPDX-License-Identifier: MIT
#pragma once

#include "model/scene/Scene.h"

namespace crowd::model {

/// Whether an edit changed a scene-level entry. Numbers are compared by their bits, as columns are:
/// a not-a-number is the same as itself, and 0 is not the same as -0, so that undo restores
/// identical bytes.
[[nodiscard]] bool isSame(const TemplateEntry& a, const TemplateEntry& b);
[[nodiscard]] bool isSame(const StageEntry& a, const StageEntry& b);
[[nodiscard]] bool isSame(const std::vector<NamedCamera>& a, const std::vector<NamedCamera>& b);
[[nodiscard]] bool isSame(const Lighting& a, const Lighting& b);
[[nodiscard]] bool isSame(const Place& a, const Place& b);
[[nodiscard]] bool isSame(const Path& a, const Path& b);
[[nodiscard]] bool isSame(const std::vector<Rule>& a, const std::vector<Rule>& b);
[[nodiscard]] bool isSame(const std::vector<NumberName>& a, const std::vector<NumberName>& b);
[[nodiscard]] bool isSame(const std::vector<Cue>& a, const std::vector<Cue>& b);

} // namespace crowd::model
