// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// What the environment of a scene is made of (see EnvironmentText.h), for scripts and the manual.
namespace crowd::model {

/// A JSON object made of the descriptions of fields. "entries": places, paths and so on;
/// "triggers", "conditions", "actions": the kinds that there are. Each has a "name" in upper camel
/// case, "doc" and "fields"; entries the "list" of the environment that they stand in (none: they
/// stand in others), kinds their "kind" in files. Of a field: "key", "type", "doc", "default", and
/// where there are any "unit", "low", "high", "choices", "refers" (the entry whose id it is);
/// "isNeeded" where files must have it.
[[nodiscard]] std::string environmentSchema();

} // namespace crowd::model
