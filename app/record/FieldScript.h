// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/describe/Field.h"

namespace crowd::app {

/// Assignments to the Python object of this name, a line for each stored field in which two objects
/// differ: run on one that is as the first was, they make it as the second is. Members of
/// enumerations that are no Python enumeration are texts, their choices' keys.
[[nodiscard]] std::string fieldChanges(std::span<const model::FieldInfo> fields, const void* was,
                                       const void* now, const std::string& name);

/// Arguments of a Python call, name and value: the stored fields in which two objects differ.
[[nodiscard]] std::vector<std::pair<std::string, std::string>>
fieldArguments(std::span<const model::FieldInfo> fields, const void* was, const void* now);

} // namespace crowd::app
