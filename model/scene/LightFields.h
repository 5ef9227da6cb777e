// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "model/describe/Field.h"

/// Description of Lighting, which files and scripts are checked by.
namespace crowd::model {

/// The keys are those of project files.
[[nodiscard]] std::span<const FieldInfo> lightFields();

} // namespace crowd::model
