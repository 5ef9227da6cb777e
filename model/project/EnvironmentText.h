// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/base/Result.h"
#include "model/scene/SceneMembers.h"

/// Places, paths, groups, tags, rules and what belongs to them apart from the rest of a project,
/// for scripts.
namespace crowd::model {

/// The members that belong to it.
[[nodiscard]] MemberSet environmentMembers();

/// A JSON object with the members "places", "paths", "tags", "rules", "numbers", "cues", "groups",
/// "surface", "stepsPerSecond" as the project file has them; those that are meant, also where they
/// are empty.
[[nodiscard]] std::string environmentText(const Scene& scene,
                                          const MemberSet& meant = environmentMembers());

/// Puts what the text holds in the place of what the scene has; members that are not there stay.
/// A problem names the member that is wrong, and the scene is as before. Strict: members that
/// neither this version nor the scene knows are refused, and what checkEnvironment() finds.
[[nodiscard]] Result<void> readEnvironmentText(const std::string& text, Scene& scene,
                                               bool isStrict = true);

} // namespace crowd::model
