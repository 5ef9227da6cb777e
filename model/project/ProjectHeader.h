// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "model/base/Result.h"
#include "model/scene/Scene.h"

namespace crowd::model {

inline constexpr const char* kProjectFormat = "crowdbrush-scene";
inline constexpr unsigned kProjectVersion = 1;

/// Everything of a scene but its individuals, as members of the project file's top-level object.
/// Unknown members of the scene are added back.
[[nodiscard]] nlohmann::json headerToJson(const Scene& scene);

/// The reverse. Checks format and version first; the message names the member that is wrong.
/// Members that this version does not know end up in Scene::unknownMembers.
[[nodiscard]] Result<Scene> headerFromJson(const nlohmann::json& top);

} // namespace crowd::model
