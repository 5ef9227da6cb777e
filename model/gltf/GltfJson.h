// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "model/base/Result.h"

/// The raw JSON of a glTF file, and reading it without exceptions.
namespace crowd::model::gltf {

using Json = nlohmann::json;

/// Parses UTF-8 text, nested at most kMaxJsonDepth deep and with at most kMaxJsonValues values. The
/// root is an object.
Result<Json> parseJson(std::string_view text);

/// Member `key` of an object; null where there is none or `object` is none.
[[nodiscard]] const Json& member(const Json& object, const char* key);

/// A whole number that fits an index or a length; 3.0 counts as 3.
[[nodiscard]] std::optional<std::uint64_t> asWhole(const Json& value);
/// Member as whole number; `fallback` where it is missing or something else.
[[nodiscard]] std::uint64_t wholeOr(const Json& object, const char* key, std::uint64_t fallback);
/// Member as text, empty where it is missing or something else.
[[nodiscard]] std::string textOf(const Json& object, const char* key);
/// Length of an array member; 0 where there is none.
[[nodiscard]] std::size_t countOf(const Json& root, const char* arrayKey);
/// Name of member as a place in messages: place("nodes", 3) is "nodes[3]".
[[nodiscard]] std::string place(std::string_view array, std::size_t index);

} // namespace crowd::model::gltf
