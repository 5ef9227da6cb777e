// SPDX-License-Identifier: MIT
#include "model/project/TakeFiles.h"

#include <algorithm>
#include <unistd.h>

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>

#include "model/project/Autosave.h"
#include "model/project/WholeFile.h"

namespace crowd::model {

namespace {

const QString kTakesSuffix = QStringLiteral(".takes");
constexpr std::uint64_t kCopiedAtOnce = 16ULL << 20U; ///< bytes

/// Names come from files: none leads out of the folder.
bool isPlainName(const QString& name)
{
    return !name.isEmpty() && !name.startsWith(QLatin1Char('.')) &&
           !name.contains(QLatin1Char('/')) && !name.contains(QChar(u'\0'));
}

/// Its own first.
QStringList foldersBeside(const QString& projectPath)
{
    const QDir beside = QFileInfo(projectPath).absoluteDir();
    QStringList folders{takesFolder(projectPath)};
    for (const QString& name : beside.entryList({QLatin1Char('*') + kTakesSuffix},
                                                QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
        folders << beside.filePath(name);
    }
    return folders;
}

Result<void> copied(const MotionFile& from, const QString& to)
{
    auto file = WholeFile::begin(to);
    if (!file) {
        return file.error();
    }
    for (std::uint64_t done = 0; done < from.size(); done += kCopiedAtOnce) {
        const auto bytes = from.read(done, std::min(kCopiedAtOnce, from.size() - done));
        if (!bytes) {
            return bytes.error();
        }
        auto written = file.value().write(
            {reinterpret_cast<const char*>(bytes.value().data()), bytes.value().size()});
        if (!written) {
            return written;
        }
    }
    return file.value().commit();
}

void openOne(Take& take, const QString& projectPath)
{
    const QString name = QString::fromStdString(take.file);
    if (isPlainName(name)) {
        for (const QString& folder : foldersBeside(projectPath)) {
            const QString path = QDir(folder).filePath(name);
            if (QFileInfo::exists(path)) {
                const auto file = MotionFile::open(path);
                take.motion = file ? file.value() : nullptr;
                take.problem = file ? Message() : file.error().said;
                return;
            }
        }
    }
    take.problem = Message(
        QT_TRANSLATE_NOOP("Messages", "The motion of the take \"%1\" is missing: put its file %2 "
                                      "into the folder %3, or delete the take."),
        take.name, take.file, takesFolder(projectPath).toStdString());
}

} // namespace

QString takesFolder(const QString& projectPath)
{
    const QFileInfo project(projectPath);
    const QString name = project.fileName();
    // "Show.crowd.host-17.autosave" is one of "Show.crowd".
    const auto end = name.indexOf(QLatin1String(".crowd"));
    return project.absoluteDir().filePath((end > 0 ? name.left(end) : name) + kTakesSuffix);
}

QString newTakesFolder(const QString& projectPath)
{
    return takesFolder(projectPath.isEmpty() ? autosavePath(QString()) : projectPath);
}

Result<void> placeTakes(const Scene& scene, const QString& projectPath)
{
    const QDir folder(takesFolder(projectPath));
    for (const Take& take : scene.takes) {
        const QString target = folder.filePath(QString::fromStdString(take.file));
        if (!take.motion || QFileInfo::exists(target)) {
            continue;
        }
        const QByteArray from = QFile::encodeName(take.motion->path());
        if (!QDir().mkpath(folder.path()) ||
            ::link(from.constData(), QFile::encodeName(target).constData()) != 0) {
            if (const auto done = copied(*take.motion, target); !done) {
                return Error{QT_TRANSLATE_NOOP("Messages",
                                               "%1: could not be written (%2). The take \"%3\" "
                                               "would be lost; choose another place or free some "
                                               "room."),
                             target.toStdString(), done.error().said, take.name};
            }
        }
    }
    return {};
}

void openTakes(Scene& scene, const QString& projectPath)
{
    std::size_t opened = 0;
    for (Take& take : scene.takes) {
        if (take.motion) {
            continue;
        }
        if (++opened > kMostTakes) {
            take.problem =
                Message(QT_TRANSLATE_NOOP(
                            "Messages",
                            "There are more takes than %1: the others are not opened. Delete some, "
                            "save and open the project again."),
                        kMostTakes);
            continue;
        }
        openOne(take, projectPath);
    }
}

} // namespace crowd::model
