// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "model/base/Result.h"
#include "model/describe/Field.h"

/// What follows from descriptions wherever values come from outside.
namespace crowd::model {

/// Whether a value is one that the field may have: within its legal range, a choice that there is,
/// a range that does not run backwards. The message begins with `name` and says what is allowed.
[[nodiscard]] Result<void> checkField(const FieldInfo& field, const FieldValue& value,
                                      const std::string& name);

/// The same for all fields of an object, with those of structs inside; `prefix` is put in front of
/// their keys ("brush.create.").
[[nodiscard]] Result<void> checkFields(std::span<const FieldInfo> fields, const void* object,
                                       const std::string& prefix);

/// The name that scripts have for a key: "sun_azimuth" for "sunAzimuth".
[[nodiscard]] std::string attributeOf(std::string_view key);

/// A short decimal text of a number, for messages.
[[nodiscard]] std::string shortNumber(double value);

} // namespace crowd::model
