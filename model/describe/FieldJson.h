// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "model/describe/Field.h"
#include "model/project/JsonFields.h"

/// Described structs as members of JSON objects, under their keys. Members of enumerations are the
/// keys of their choices, colours "#rrggbb", tints "#rrggbbaa", ranges and points lists of numbers,
/// clips objects with "clip" and "weight", a mix of templates objects with "template" and "weight".
namespace crowd::model {

/// What becomes of a value that is wrong.
enum class WrongValue : std::uint8_t {
    Complain, ///< it is the first problem of JsonFields, which ends the reading
    Keep      ///< the member keeps what it has, as settings that only remember
};

/// Adds the stored fields to an object; structs inside are objects of their own, and so are the
/// items of lists, without what is as an item begins.
void addFields(nlohmann::json& object, std::span<const FieldInfo> fields, const void* data);
/// What is not there stays as it is. Complaints name the place and what is allowed.
void readFields(JsonFields& source, std::span<const FieldInfo> fields, void* data,
                WrongValue wrong = WrongValue::Complain);
/// The same of one field that is no struct.
void readField(JsonFields& source, const FieldInfo& field, void* data,
               WrongValue wrong = WrongValue::Complain);

/// A number within limits.
void readWithin(JsonFields& fields, const char* key, float low, float high, float& value);
/// "#rrggbb".
[[nodiscard]] std::string colorText(const PaintColor& color);
void readColor(JsonFields& fields, const char* key, PaintColor& color);

} // namespace crowd::model
