// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "model/describe/Field.h"

/// Descriptions of the entries that the parts of rules refer to, of rules themselves, and of what
/// all conditions and all actions have beside the fields of their kind. Members that are lists of
/// other entries are not among them.
namespace crowd::model {

[[nodiscard]] std::span<const FieldInfo> placeFields();     ///< of a Place
[[nodiscard]] std::span<const FieldInfo> pathFields();      ///< of a Path
[[nodiscard]] std::span<const FieldInfo> branchFields();    ///< of a PathBranch
[[nodiscard]] std::span<const FieldInfo> tagFields();       ///< of a TagName
[[nodiscard]] std::span<const FieldInfo> numberFields();    ///< of a NumberName
[[nodiscard]] std::span<const FieldInfo> cueFields();       ///< of a Cue
[[nodiscard]] std::span<const FieldInfo> cueRecallFields(); ///< those about a state
[[nodiscard]] std::span<const FieldInfo> ruleFields();      ///< of a Rule
[[nodiscard]] std::span<const FieldInfo> conditionFields(); ///< of a Condition
[[nodiscard]] std::span<const FieldInfo> actionFields();    ///< of an Action

} // namespace crowd::model
