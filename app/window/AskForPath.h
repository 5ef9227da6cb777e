// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtCore/QString>
#include <QtCore/QStringList>

class QWidget;

namespace crowd::app {

/// A kind of file that something is saved as.
struct SaveKind
{
    QString name;
    QStringList endings; ///< without the dot; the first is the usual
};

/// Asks where something made of a scene is to be saved; proposes the folder of last time, else that
/// of the scene's file, else `usualFolder`, and the scene's name, else `usualName`. The kind that
/// is chosen gives the ending. Empty: cancelled.
[[nodiscard]] QString askForPath(QWidget* window, const QString& title,
                                 const std::vector<SaveKind>& kinds, const QString& settingsKey,
                                 const QString& scenePath, const QString& usualFolder,
                                 const QString& usualName);

} // namespace crowd::app
