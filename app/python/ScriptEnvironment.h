// SPDX-License-Identifier: MIT
#pragma once

#include "app/python/ScriptScene.h"

/// Cameras, light, places, paths, tags and rules as scripts change them. Each is a part of the open
/// edit, or a step of its own; what is refused is refused before anything changes.
namespace crowd::app {

[[nodiscard]] model::Result<model::Camera> cameraNamed(const ScriptScene& script,
                                                       const std::string& name);
/// No look named: it keeps the one that it has; an empty name: none.
[[nodiscard]] model::Result<void> setCamera(ScriptScene& script, const std::string& name,
                                            const model::Camera& camera,
                                            const std::optional<std::string>& look);
/// Of the look of a scene; 0 for an empty name.
[[nodiscard]] model::Result<model::LookId> lookNamed(const model::Scene& scene,
                                                     const std::string& name);
[[nodiscard]] model::Result<void> removeCamera(ScriptScene& script, const std::string& name);
/// All of them, in this order; their looks are there.
[[nodiscard]] model::Result<void> setCameras(ScriptScene& script,
                                             std::vector<model::NamedCamera> cameras);
[[nodiscard]] model::Result<void> setLighting(ScriptScene& script, model::Lighting lighting);
/// Places, paths, tags and rules as JSON: see readEnvironmentText.
[[nodiscard]] model::Result<void> setEnvironment(ScriptScene& script, const std::string& text,
                                                 bool isStrict);
/// Ready-made rules, for the clips and places that the scene has now, with the cues that they
/// listen to: one step. Their ids.
[[nodiscard]] model::Result<std::vector<model::RuleId>> addRuleSet(ScriptScene& script,
                                                                   const std::string& key);
/// "audience, stadium wave".
[[nodiscard]] std::string ruleSetKeys();

} // namespace crowd::app
