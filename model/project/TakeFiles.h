// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

#include "model/base/Result.h"
#include "model/scene/Scene.h"

/// Where the motion of kept takes lies: "Show.takes" beside "Show.crowd". Files in it never change.
namespace crowd::model {

/// Of a project, or of an autosave of it.
[[nodiscard]] QString takesFolder(const QString& projectPath);
/// Where takes of a project are written; of an unsaved one (an empty path) beside its autosave.
[[nodiscard]] QString newTakesFolder(const QString& projectPath);

/// What lies elsewhere of takes comes into the project's own folder too: as a second name of the
/// same file where that can be had, else as a copy.
[[nodiscard]] Result<void> placeTakes(const Scene& scene, const QString& projectPath);

/// Opens what takes lack of motion, from the project's own folder or another one of takes beside
/// it. One that cannot be had says why in its `problem`, and is kept.
void openTakes(Scene& scene, const QString& projectPath);

} // namespace crowd::model
