// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <QtCore/QString>

#include "model/base/Result.h"
#include "model/scene/Scene.h"

namespace crowd::app {

/// What a command that draws without a window works on: a project with its assets, or a lone glTF
/// file as a scene of its own (a template as one individual at the origin, or a stage), with a
/// camera that shows all of it. "builtin:scenes/city.crowd" names what comes with the program.
[[nodiscard]] model::Result<model::Scene> loadForPicture(const QString& path);

/// A template that comes with the program ("builtin:templates/man.glb").
[[nodiscard]] model::Result<model::TemplatePtr> loadBuiltinTemplate(const std::string& name);

} // namespace crowd::app
