// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

#include "model/base/Result.h"
#include "model/scene/Scene.h"

namespace crowd::model {

/// Writes the scene to a .crowd file, whole or not at all; see WholeFile. Asset paths below or near
/// the file become relative to its folder; "builtin:" ones stay.
[[nodiscard]] Result<void> saveProject(const Scene& scene, const QString& path);

/// Reads a .crowd file without its assets; relative asset paths become absolute. The message of a
/// failure begins with the file's name.
[[nodiscard]] Result<Scene> readProject(const QString& path);

} // namespace crowd::model
