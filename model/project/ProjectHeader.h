// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "model/base/Result.h"
#include "model/scene/Scene.h"

namespace crowd::model {

inline constexpr const char* kProjectFormat = "crowdbrush-scene";
inline constexpr unsigned kProjectVersion = 1;

/// Ids above this are refused: who comes later needs some too.
inline constexpr IndividualId kMaxIndividualId = 4'000'000'000U;

/// Everything of a scene but its individuals, as members of the project file's top-level object.
/// Unknown members of the scene are added back.
[[nodiscard]] nlohmann::json headerToJson(const Scene& scene);

/// Is it a scene, and of a version that this program reads? The message is for the artist.
[[nodiscard]] Result<void> checkFormat(const nlohmann::json& top);

/// The reverse of headerToJson(); the format was checked. The message names the member that is
/// wrong. Members that this version does not know are kept where they stood.
[[nodiscard]] Result<Scene> headerFromJson(const nlohmann::json& top);

} // namespace crowd::model
