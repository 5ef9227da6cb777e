// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "model/project/JsonEntries.h"
#include "model/scene/SceneMembers.h"

/// Cameras, light and looks as members of the project file (see MemberJson.h).
namespace crowd::model {

[[nodiscard]] nlohmann::json memberJson(members::Cameras, const Scene& scene);
void readMember(members::Cameras, JsonFields& top, Scene& scene, Message& problem);
[[nodiscard]] nlohmann::json memberJson(members::Light, const Scene& scene);
void readMember(members::Light, JsonFields& top, Scene& scene, Message& problem);
/// In the order of the file, which is the one in which they are shown; names are of one each.
void readMember(members::Looks, JsonFields& top, Scene& scene, Message& problem);

} // namespace crowd::model
