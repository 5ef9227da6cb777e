// SPDX-License-Identifier: MIT
#include "model/project/CollectAssets.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QUrl>

#include <nlohmann/json.hpp>

#include "model/project/AssetPaths.h"

namespace crowd::model {

namespace {

using nlohmann::json;

Error copyError(const QString& file, const QString& why)
{
    return Error{(file + QStringLiteral(": could not be copied (") + why + QStringLiteral(")."))
                     .toStdString()};
}

/// Files that a .gltf names in its buffers and images, relative to it. A .glb has them inside, and
/// what it still names is listed too.
QStringList referencedFiles(const QString& asset)
{
    QFile file(asset);
    QStringList names;
    if (!file.open(QIODevice::ReadOnly)) {
        return names;
    }
    QByteArray bytes = file.readAll();
    if (bytes.startsWith("glTF")) {
        constexpr qsizetype kHeader = 20;
        bytes = bytes.mid(kHeader, bytes.indexOf("BIN", kHeader) - kHeader - 4);
    }
    const json top =
        json::parse(bytes.constData(), bytes.constData() + bytes.size(), nullptr, false);
    for (const char* list : {"buffers", "images"}) {
        if (!top.is_object() || !top.contains(list) || !top[list].is_array()) {
            continue;
        }
        for (const json& item : top[list]) {
            const std::string uri = item.is_object() ? item.value("uri", std::string()) : "";
            if (!uri.empty() && !uri.starts_with("data:")) {
                names << QUrl::fromPercentEncoding(QByteArray::fromStdString(uri));
            }
        }
    }
    return names;
}

Result<void> copyFile(const QString& from, const QString& to)
{
    if (QFileInfo(from) == QFileInfo(to)) {
        return {};
    }
    if (!QDir().mkpath(QFileInfo(to).absolutePath())) {
        return copyError(from, QFileInfo(to).absolutePath());
    }
    QFile::remove(to);
    QFile source(from);
    if (!source.copy(to)) {
        return copyError(from, source.errorString());
    }
    return {};
}

/// The path of the copy.
Result<std::string> collect(const std::string& assetPath, const QString& folder)
{
    const QFileInfo source(QString::fromStdString(assetPath));
    QDir target(folder + QStringLiteral("/assets/") + source.completeBaseName());
    const QString copy = target.absoluteFilePath(source.fileName());
    if (const auto copied = copyFile(source.absoluteFilePath(), copy); !copied) {
        return copied.error();
    }
    for (const QString& name : referencedFiles(source.absoluteFilePath())) {
        const QString inside = QDir::cleanPath(target.absoluteFilePath(name));
        if (!inside.startsWith(target.absolutePath() + QLatin1Char('/'))) {
            return copyError(name, QStringLiteral("it lies outside the folder of its asset"));
        }
        if (const auto copied = copyFile(source.dir().absoluteFilePath(name), inside); !copied) {
            return copied.error();
        }
    }
    return copy.toStdString();
}

template<class Entry>
Result<void> collectEntries(const std::vector<Entry>& entries, const QString& folder,
                            std::vector<Entry>& changed)
{
    for (Entry entry : entries) {
        if (isBuiltin(entry.path) || !entry.asset) {
            continue;
        }
        const Result<std::string> path = collect(entry.path, folder);
        if (!path) {
            return path.error();
        }
        if (path.value() != entry.path) {
            entry.path = path.value();
            changed.push_back(std::move(entry));
        }
    }
    return {};
}

} // namespace

Result<CollectedEntries> collectAssets(const Scene& scene, const QString& folder)
{
    CollectedEntries collected;
    if (const auto done = collectEntries(scene.templates, folder, collected.templates); !done) {
        return done.error();
    }
    if (const auto done = collectEntries(scene.stages, folder, collected.stages); !done) {
        return done.error();
    }
    return collected;
}

} // namespace crowd::model
