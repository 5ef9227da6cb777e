// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "model/project/JsonEntries.h"
#include "model/scene/SceneMembers.h"

/// Rules and what they name as members of the project file (see MemberJson.h).
namespace crowd::model {

[[nodiscard]] nlohmann::json memberJson(members::Rules, const Scene& scene);
void readMember(members::Rules, JsonFields& top, Scene& scene, Message& problem);
[[nodiscard]] nlohmann::json memberJson(members::Tags, const Scene& scene);
void readMember(members::Tags, JsonFields& top, Scene& scene, Message& problem);
[[nodiscard]] nlohmann::json memberJson(members::Numbers, const Scene& scene);
void readMember(members::Numbers, JsonFields& top, Scene& scene, Message& problem);
[[nodiscard]] nlohmann::json memberJson(members::Cues, const Scene& scene);
void readMember(members::Cues, JsonFields& top, Scene& scene, Message& problem);

} // namespace crowd::model
