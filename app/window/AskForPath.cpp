// SPDX-License-Identifier: MIT
#include "app/window/AskForPath.h"

#include <QtCore/QFileInfo>
#include <QtCore/QSettings>
#include <QtWidgets/QFileDialog>

namespace crowd::app {

namespace {

QString filterOf(const SaveKind& kind)
{
    QStringList patterns;
    for (const QString& ending : kind.endings) {
        patterns << QStringLiteral("*.") + ending;
    }
    return QStringLiteral("%1 (%2)").arg(kind.name, patterns.join(QLatin1Char(' ')));
}

} // namespace

QString askForPath(QWidget* window, const QString& title, const std::vector<SaveKind>& kinds,
                   const QString& settingsKey, const QString& scenePath, const QString& usualFolder,
                   const QString& usualName)
{
    QSettings settings;
    const QFileInfo scene(scenePath);
    const QString usual = scenePath.isEmpty() ? usualFolder : scene.absolutePath();
    QStringList filters;
    for (const SaveKind& kind : kinds) {
        filters << filterOf(kind);
    }
    QFileDialog dialog(window, title, settings.value(settingsKey, usual).toString(),
                       filters.join(QStringLiteral(";;")));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(kinds.front().endings.front());
    dialog.selectFile(scenePath.isEmpty() ? usualName : scene.completeBaseName());
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString& filter) {
        for (const SaveKind& kind : kinds) {
            if (filter == filterOf(kind)) {
                dialog.setDefaultSuffix(kind.endings.front());
            }
        }
    });
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) {
        return {};
    }
    QString path = dialog.selectedFiles().front();
    settings.setValue(settingsKey, QFileInfo(path).absolutePath());
    return path;
}

} // namespace crowd::app
