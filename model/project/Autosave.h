// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QDateTime>
#include <QtCore/QString>
#include <QtCore/QStringList>

#include "model/base/Result.h"
#include "model/scene/Scene.h"

namespace crowd::model {

/// Where the unsaved state of a document is kept: beside its file as NAME.crowd.autosave, or, for
/// one never saved, in the folder for application data under a name of its own process.
/// The editor writes it on a timer and removes it on a clean save or close, so one that is found
/// later is left from a crash.
[[nodiscard]] QString autosavePath(const QString& projectPath);

/// Asset paths in it are relative to where it lies, as in any project.
[[nodiscard]] Result<void> writeAutosave(const Scene& scene, const QString& projectPath);
void removeAutosave(const QString& projectPath);

/// A recovery beside the project that is newer than it; empty when there is none.
[[nodiscard]] QString findRecovery(const QString& projectPath);
/// Recoveries of documents that were never saved and whose process is gone.
[[nodiscard]] QStringList findUntitledRecoveries();

} // namespace crowd::model
