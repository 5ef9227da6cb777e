// SPDX-License-Identifier: MIT
#include "model/project/AssetPaths.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QDir>
#include <QtCore/QFileInfo>

namespace crowd::model {

namespace {

constexpr const char* kBuiltinPrefix = "builtin:";

/// Set once when a module is loaded, before any thread reads it.
QString& moduleFolder()
{
    static QString folder;
    return folder;
}

} // namespace

bool isBuiltin(const std::string& assetPath)
{
    return assetPath.starts_with(kBuiltinPrefix);
}

QString builtinFolder()
{
    const QString fromEnvironment = qEnvironmentVariable("CROWDBRUSH_RESOURCES");
    if (!fromEnvironment.isEmpty()) {
        return fromEnvironment;
    }
    // The link that /proc keeps needs no application object: modules and tests have none.
    const QDir program(moduleFolder().isEmpty()
                           ? QFileInfo(QStringLiteral("/proc/self/exe")).canonicalPath()
                           : moduleFolder());
    for (const char* candidate : {"../../resources", "../../../resources", "../share/crowdbrush"}) {
        const QString folder =
            QDir::cleanPath(program.absoluteFilePath(QString::fromLatin1(candidate)));
        if (QFileInfo::exists(folder + QStringLiteral("/templates"))) {
            return folder;
        }
    }
    return {};
}

void setProgramFolder(const QString& folder)
{
    moduleFolder() = folder;
}

QString assetFile(const std::string& assetPath)
{
    const QString path = QString::fromStdString(assetPath);
    if (!isBuiltin(assetPath)) {
        return path;
    }
    const QString root = builtinFolder() + QLatin1Char('/');
    const QString file = QDir::cleanPath(
        root + path.mid(static_cast<qsizetype>(std::char_traits<char>::length(kBuiltinPrefix))));
    return file.startsWith(QDir::cleanPath(root) + QLatin1Char('/')) ? file : QString();
}

std::string storedAssetPath(const std::string& assetPath, const QString& folder)
{
    if (isBuiltin(assetPath) || assetPath.empty()) {
        return assetPath;
    }
    return QDir(folder).relativeFilePath(QString::fromStdString(assetPath)).toStdString();
}

std::string absoluteAssetPath(const std::string& storedPath, const QString& folder)
{
    if (isBuiltin(storedPath) || storedPath.empty()) {
        return storedPath;
    }
    QString path =
        QDir::cleanPath(QDir(folder).absoluteFilePath(QString::fromStdString(storedPath)));
    while (path.startsWith(QStringLiteral("/../"))) {
        path.remove(0, 3); // there is nothing above the root
    }
    return path.toStdString();
}

} // namespace crowd::model
