// SPDX-License-Identifier: MIT
#pragma once

#include "app/python/ScriptScene.h"

/// Templates and stages as scripts change them. Each is a part of the open edit, or a step of its
/// own; what is refused is refused before anything changes.
namespace crowd::app {

/// Loads the entry's file. An id of 0 stands for the next free one, an empty name for the file's
/// own.
[[nodiscard]] model::Result<model::TemplateId> addTemplate(ScriptScene& script,
                                                           model::TemplateEntry entry);
/// By id; loads the file again where path, import or speeds are others.
[[nodiscard]] model::Result<void> changeTemplate(ScriptScene& script, model::TemplateEntry entry);
/// That nobody uses.
[[nodiscard]] model::Result<void> removeTemplate(ScriptScene& script, model::TemplateId id);
[[nodiscard]] model::Result<std::uint8_t> addStage(ScriptScene& script, model::StageEntry entry);
[[nodiscard]] model::Result<void> changeStage(ScriptScene& script, model::StageEntry entry);
[[nodiscard]] model::Result<void> removeStage(ScriptScene& script, std::uint8_t id);

} // namespace crowd::app
