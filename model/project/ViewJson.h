// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "model/project/JsonEntries.h"
#include "model/scene/SceneMembers.h"

/// Cameras and light as members of the project file (see MemberJson.h).
namespace crowd::model {

[[nodiscard]] nlohmann::json memberJson(members::Cameras, const Scene& scene);
void readMember(members::Cameras, JsonFields& top, Scene& scene, Message& problem);
[[nodiscard]] nlohmann::json memberJson(members::Light, const Scene& scene);
void readMember(members::Light, JsonFields& top, Scene& scene, Message& problem);

} // namespace crowd::model
