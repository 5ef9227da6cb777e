// SPDX-License-Identifier: MIT
#include "model/project/ProjectFile.h"

#include <string_view>

#include <QtCore/QFile>
#include <QtCore/QFileInfo>

#include "model/project/AssetPaths.h"
#include "model/project/ProjectReader.h"
#include "model/project/ProjectWriter.h"
#include "model/project/TakeFiles.h"
#include "model/project/WholeFile.h"

namespace crowd::model {

namespace {

/// Text that holds four million people; anything larger is not one of our scenes.
constexpr qint64 kMaxFileBytes = qint64{1} << 30;

template<class Change>
void changePaths(Scene& scene, const Change& change)
{
    for (TemplateEntry& entry : scene.templates) {
        entry.path = change(entry.path);
    }
    for (StageEntry& entry : scene.stages) {
        entry.path = change(entry.path);
    }
}

} // namespace

Result<void> saveProject(const Scene& scene, const QString& path)
{
    const QString folder = QFileInfo(path).absolutePath();
    Scene written = scene; // columns are shared
    changePaths(written, [&](const std::string& asset) { return storedAssetPath(asset, folder); });
    const Result<std::string> text = projectToText(written);
    if (!text) {
        return Error{QT_TRANSLATE_NOOP("Messages", "The scene was not saved. %1"),
                     text.error().said};
    }
    if (const auto placed = placeTakes(scene, path); !placed) {
        return Error{QT_TRANSLATE_NOOP("Messages", "The scene was not saved. %1"),
                     placed.error().said};
    }
    if (const auto saved = writeWholeFile(path, text.value()); !saved) {
        return Error{QT_TRANSLATE_NOOP("Messages",
                                       "%1: could not be written (%2). The scene was not saved; "
                                       "choose another place or free some room."),
                     path.toStdString(), saved.error().said};
    }
    return {};
}

Result<Scene> readProject(const QString& path)
{
    QFile file(path);
    const QFileInfo info(path);
    if (info.exists() && !info.isFile()) { // a pipe or a device might never end
        return Error{QT_TRANSLATE_NOOP("Messages", "%1: is not a file; choose a .crowd file."),
                     path.toStdString()};
    }
    if (!file.open(QIODevice::ReadOnly)) {
        return Error{QT_TRANSLATE_NOOP(
                         "Messages",
                         "%1: could not be opened (%2). Check its name and that you may read it."),
                     path.toStdString(), file.errorString().toStdString()};
    }
    if (file.size() > kMaxFileBytes) {
        return Error{
            QT_TRANSLATE_NOOP("Messages", "%1: is larger than 1 GiB, too large for a scene."),
            path.toStdString()};
    }
    const QByteArray bytes = file.readAll();
    if (bytes.size() < file.size()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1: could not be read to its end (%2)."),
                     path.toStdString(), file.errorString().toStdString()};
    }
    Result<Scene> scene = projectFromText(
        std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
    if (!scene) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1: %2"), path.toStdString(),
                     scene.error().said};
    }
    const QString folder = QFileInfo(path).absolutePath();
    changePaths(scene.value(),
                [&](const std::string& asset) { return absoluteAssetPath(asset, folder); });
    openTakes(scene.value(), path);
    return scene;
}

} // namespace crowd::model
