// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QDir>
#include <QtCore/QFileInfo>
#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtCore/QString>

namespace crowd::widgets {

/// A file of that name in the folder that was chosen last for its kind; at first in that of the
/// scene, and where it has none in the artist's documents. `setting`: of the kind.
[[nodiscard]] inline QString inLastFolder(const QString& setting, const QString& scenePath,
                                          const QString& name)
{
    const QString usual = scenePath.isEmpty()
                              ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                              : QFileInfo(scenePath).absolutePath();
    return QDir(QSettings().value(setting, usual).toString()).filePath(name);
}

inline void rememberFolder(const QString& setting, const QString& path)
{
    QSettings().setValue(setting, QFileInfo(path).absolutePath());
}

} // namespace crowd::widgets
