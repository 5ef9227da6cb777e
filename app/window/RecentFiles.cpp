// SPDX-License-Identifier: MIT
#include "app/window/RecentFiles.h"

#include <QtCore/QFileInfo>
#include <QtCore/QSettings>

namespace crowd::app {

namespace {

const QString kKey = QStringLiteral("files/recent");

QStringList without(const QString& path)
{
    QStringList recent = recentFiles();
    recent.removeAll(QFileInfo(path).absoluteFilePath());
    return recent;
}

} // namespace

QStringList recentFiles()
{
    return QSettings().value(kKey).toStringList();
}

void addRecentFile(const QString& path)
{
    QStringList recent = without(path);
    recent.prepend(QFileInfo(path).absoluteFilePath());
    QSettings().setValue(kKey, QStringList(recent.mid(0, kMaxRecentFiles)));
}

void removeRecentFile(const QString& path)
{
    QSettings().setValue(kKey, without(path));
}

void clearRecentFiles()
{
    QSettings().remove(kKey);
}

} // namespace crowd::app
