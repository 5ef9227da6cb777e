// SPDX-License-Identifier: MIT
#include "model/project/Autosave.h"

#include <algorithm>

#include <QtCore/QCryptographicHash>
#include <QtCore/QDateTime>
#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QStandardPaths>

#include "model/project/ProcessName.h"
#include "model/project/ProjectFile.h"

namespace crowd::model {

namespace {

const QString kSuffix = QStringLiteral(".autosave");
const QString kUntitled = QStringLiteral("untitled.crowd");

QString dataFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
           QStringLiteral("/unsaved");
}

/// Folder and first part of the name of a document's autosaves.
struct CopyPlace
{
    QString folder;
    QString name;

    [[nodiscard]] QString fileOf(const QString& owner) const
    {
        return folder + QLatin1Char('/') + name + QLatin1Char('.') + owner + kSuffix;
    }
};

CopyPlace placeBeside(const QString& projectPath)
{
    if (projectPath.isEmpty()) {
        return {dataFolder(), kUntitled};
    }
    const QFileInfo project(projectPath);
    return {project.absolutePath(), project.fileName()};
}

/// For a project in a folder that cannot be written.
CopyPlace placeElsewhere(const QString& projectPath)
{
    const QByteArray path = QFileInfo(projectPath).absoluteFilePath().toUtf8();
    return {dataFolder(),
            QString::fromLatin1(
                QCryptographicHash::hash(path, QCryptographicHash::Sha1).toHex().left(16)) +
                QStringLiteral(".crowd")};
}

/// The autosaves at a place, newest first, of those owners that are wanted.
template<class Wanted>
QFileInfoList keptAt(const CopyPlace& place, const Wanted& isWanted)
{
    QFileInfoList kept;
    const QString start = place.name + QLatin1Char('.');
    for (const QFileInfo& file :
         QDir(place.folder).entryInfoList(QDir::Files | QDir::Hidden, QDir::Time)) {
        const QString name = file.fileName();
        if (name.startsWith(start) && name.endsWith(kSuffix)) {
            const QString owner =
                name.mid(start.size(), name.size() - start.size() - kSuffix.size());
            if (owner.contains(QLatin1Char('-')) && isWanted(owner)) {
                kept << file;
            }
        }
    }
    return kept;
}

/// Those whose process is gone.
QFileInfoList leftAt(const CopyPlace& place)
{
    return keptAt(place, [](const QString& owner) { return !isProcessAlive(owner); });
}

QFileInfoList leftOf(const QString& projectPath)
{
    QFileInfoList left = leftAt(placeBeside(projectPath)) + leftAt(placeElsewhere(projectPath));
    std::ranges::stable_sort(left, [](const QFileInfo& a, const QFileInfo& b) {
        return a.lastModified() > b.lastModified();
    });
    return left;
}

bool isNewerThan(const QFileInfo& recovery, const QFileInfo& project)
{
    return !project.exists() || recovery.lastModified() >= project.lastModified();
}

Result<void> writeAt(const CopyPlace& place, const Scene& scene)
{
    if (!QDir().mkpath(place.folder)) {
        return Error{QT_TRANSLATE_NOOP(
                         "Messages", "%1: the folder could not be made; unsaved work is not kept."),
                     place.folder.toStdString()};
    }
    return saveProject(scene, place.fileOf(ownProcessName()));
}

} // namespace

QString autosavePath(const QString& projectPath)
{
    return placeBeside(projectPath).fileOf(ownProcessName());
}

Result<void> writeAutosave(const Scene& scene, const QString& projectPath)
{
    Result<void> beside = writeAt(placeBeside(projectPath), scene);
    if (beside || projectPath.isEmpty()) {
        return beside;
    }
    return writeAt(placeElsewhere(projectPath), scene) ? Result<void>() : beside;
}

void removeAutosave(const QString& projectPath)
{
    QFile::remove(autosavePath(projectPath));
    if (!projectPath.isEmpty()) {
        QFile::remove(placeElsewhere(projectPath).fileOf(ownProcessName()));
    }
}

QString findRecovery(const QString& projectPath)
{
    if (projectPath.isEmpty()) {
        return {};
    }
    const QFileInfoList left = leftOf(projectPath);
    const bool isUseful = !left.isEmpty() && isNewerThan(left.front(), QFileInfo(projectPath));
    return isUseful ? left.front().absoluteFilePath() : QString();
}

bool isKeptByAnother(const QString& projectPath)
{
    const auto isOther = [](const QString& owner) {
        return owner != ownProcessName() && isProcessAlive(owner);
    };
    return !keptAt(placeBeside(projectPath), isOther).isEmpty() ||
           !keptAt(placeElsewhere(projectPath), isOther).isEmpty();
}

QStringList findUntitledRecoveries()
{
    QStringList found;
    for (const QFileInfo& file : leftAt(placeBeside({}))) {
        found << file.absoluteFilePath();
    }
    return found;
}

void adoptRecovery(const QString& recovery, const QString& projectPath)
{
    const CopyPlace place = QFileInfo(recovery).absolutePath() == placeBeside(projectPath).folder
                                ? placeBeside(projectPath)
                                : placeElsewhere(projectPath);
    // Relative asset paths in it stay right: it stays in its folder.
    QFile::remove(place.fileOf(ownProcessName()));
    QFile::rename(recovery, place.fileOf(ownProcessName()));
}

void removeOldRecoveries(const QString& projectPath)
{
    const QFileInfo project(projectPath);
    for (const QFileInfo& recovery : leftOf(projectPath)) {
        if (!isNewerThan(recovery, project)) {
            QFile::remove(recovery.absoluteFilePath());
        }
    }
}

} // namespace crowd::model
