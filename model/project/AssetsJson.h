// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "model/project/JsonEntries.h"
#include "model/scene/SceneMembers.h"

/// Templates and stages as members of the project file (see MemberJson.h).
namespace crowd::model {

[[nodiscard]] nlohmann::json memberJson(members::Templates, const Scene& scene);
void readMember(members::Templates, JsonFields& top, Scene& scene, Message& problem);
[[nodiscard]] nlohmann::json memberJson(members::Stages, const Scene& scene);
void readMember(members::Stages, JsonFields& top, Scene& scene, Message& problem);

} // namespace crowd::model
