// SPDX-License-Identifier: MIT
#include "model/project/Autosave.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QStandardPaths>

#include "model/project/ProjectFile.h"

namespace crowd::model {

namespace {

QString untitledFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
           QStringLiteral("/unsaved");
}

bool isProcessAlive(const QString& processId)
{
    return QFileInfo::exists(QStringLiteral("/proc/") + processId);
}

} // namespace

QString autosavePath(const QString& projectPath)
{
    if (!projectPath.isEmpty()) {
        return projectPath + QStringLiteral(".autosave");
    }
    return untitledFolder() +
           QStringLiteral("/%1.crowd.autosave").arg(QCoreApplication::applicationPid());
}

Result<void> writeAutosave(const Scene& scene, const QString& projectPath)
{
    const QString path = autosavePath(projectPath);
    if (!QDir().mkpath(QFileInfo(path).absolutePath())) {
        return Error{path.toStdString() + ": the folder could not be made; autosave is off."};
    }
    return saveProject(scene, path);
}

void removeAutosave(const QString& projectPath)
{
    QFile::remove(autosavePath(projectPath));
}

QString findRecovery(const QString& projectPath)
{
    const QFileInfo recovery(autosavePath(projectPath));
    if (projectPath.isEmpty() || !recovery.exists()) {
        return {};
    }
    const QFileInfo project(projectPath);
    const bool isNewer = !project.exists() || recovery.lastModified() >= project.lastModified();
    return isNewer ? recovery.absoluteFilePath() : QString();
}

QStringList findUntitledRecoveries()
{
    QStringList found;
    const QDir folder(untitledFolder());
    for (const QFileInfo& file :
         folder.entryInfoList({QStringLiteral("*.crowd.autosave")}, QDir::Files, QDir::Time)) {
        if (!isProcessAlive(file.fileName().section(QLatin1Char('.'), 0, 0))) {
            found << file.absoluteFilePath();
        }
    }
    return found;
}

} // namespace crowd::model
