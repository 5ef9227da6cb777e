// SPDX-License-Identifier: MIT
#pragma once

#include "model/scene/Scene.h"

/// What is named in the scenes that come with the program, in the language of the interface. Files
/// know no language: only an artist who opens one as a scene of their own has them so; scripts and
/// commands have them as they are written.
namespace crowd::app {

/// Of cameras, lights and states, also where a number stands behind: "Street lamp 2". What is
/// named otherwise stays.
void translateNames(model::Scene& scene);
/// What a scene is called that comes with the program, by its file.
[[nodiscard]] QString exampleName(const QString& path);
[[nodiscard]] QString translatedName(const std::string& name);
/// Whether there are words of other languages for it.
[[nodiscard]] bool isReadyName(const std::string& name);

} // namespace crowd::app
