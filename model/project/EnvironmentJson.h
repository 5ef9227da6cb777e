// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "model/project/JsonEntries.h"
#include "model/scene/SceneMembers.h"

/// Places, paths and what can be walked on as members of the project file (see MemberJson.h).
namespace crowd::model {

[[nodiscard]] nlohmann::json memberJson(members::Places, const Scene& scene);
void readMember(members::Places, JsonFields& top, Scene& scene, Message& problem);
[[nodiscard]] nlohmann::json memberJson(members::Paths, const Scene& scene);
void readMember(members::Paths, JsonFields& top, Scene& scene, Message& problem);
[[nodiscard]] nlohmann::json memberJson(members::Surface, const Scene& scene);
void readMember(members::Surface, JsonFields& top, Scene& scene, Message& problem);
[[nodiscard]] nlohmann::json memberJson(members::Steps, const Scene& scene);
void readMember(members::Steps, JsonFields& top, Scene& scene, Message& problem);

} // namespace crowd::model
