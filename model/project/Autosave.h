// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>
#include <QtCore/QStringList>

#include "model/base/Result.h"
#include "model/scene/Scene.h"

/// The unsaved state of a document is kept on disk: beside its file, or, for a document never saved
/// and where the folder cannot be written, in the folder for application data. The editor writes it
/// on a timer and removes it on a clean save or close. Each carries the name of its process, so
/// that editors do not disturb each other, and one whose process is gone is left from a crash.
namespace crowd::model {

/// Where this process keeps the document's autosave first of all. Empty projectPath: never saved.
[[nodiscard]] QString autosavePath(const QString& projectPath);

/// Asset paths in it are relative to where it lies, as in any project.
[[nodiscard]] Result<void> writeAutosave(const Scene& scene, const QString& projectPath);
/// Of this process; nothing when there is none.
void removeAutosave(const QString& projectPath);

/// The newest left from a crash that is newer than the project; empty when there is none.
[[nodiscard]] QString findRecovery(const QString& projectPath);
/// Whether another editor that runs has unsaved changes of the project.
[[nodiscard]] bool isKeptByAnother(const QString& projectPath);
/// Left of documents that were never saved, newest first.
[[nodiscard]] QStringList findUntitledRecoveries();
/// Makes a recovery that was opened this process's own autosave of the document.
void adoptRecovery(const QString& recovery, const QString& projectPath);
/// After a save: what is left from crashes and older than the file is of no use any more.
void removeOldRecoveries(const QString& projectPath);

} // namespace crowd::model
