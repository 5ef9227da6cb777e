// SPDX-License-Identifier: MIT
#include "app/commands/EditorCommand.h"

#include <cstdio>

#include <QtCore/QFileInfo>
#include <QtCore/QTranslator>
#include <QtWidgets/QApplication>

#include "app/window/MainWindow.h"
#include "app/window/PreferencesDialog.h"
#include "model/project/AssetPaths.h"
#include "widgets/theme/Icons.h"
#include "widgets/theme/Theme.h"

namespace crowd::app {

namespace {

bool hasDisplay()
{
    const QByteArray platform = qgetenv("QT_QPA_PLATFORM");
    return !qEnvironmentVariableIsEmpty("DISPLAY") ||
           !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") || platform.startsWith("offscreen");
}

void loadTranslation(QApplication& application)
{
    const QString chosen = Preferences::load().language;
    const QLocale locale = chosen.isEmpty() ? QLocale::system() : QLocale(chosen);
    auto* translator = new QTranslator(&application);
    if (translator->load(locale, QStringLiteral("crowdbrush"), QStringLiteral("_"),
                         QStringLiteral(":/translations")) ||
        translator->load(QStringLiteral(":/translations/crowdbrush_en.qm"))) {
        QApplication::installTranslator(translator);
    }
}

void openFiles(MainWindow& window, QStringList files)
{
    const QString ready = model::builtinFolder() + QStringLiteral("/scenes/theatre.crowd");
    if (files.isEmpty() && QFileInfo::exists(ready)) {
        files << ready;
    }
    if (files.isEmpty()) {
        window.files().newTheatre();
    }
    for (const QString& file : files) {
        if (QFileInfo(file).suffix().compare(QStringLiteral("crowd"), Qt::CaseInsensitive) == 0) {
            window.files().openPath(file);
        } else {
            window.assets().bring(file, false);
        }
    }
    window.files().offerUntitledRecovery();
}

} // namespace

int runEditor(int& argc, char** argv, const QStringList& files)
{
    if (!hasDisplay()) {
        std::fputs("crowdbrush: there is no display for the editor (DISPLAY is not set); "
                   "\"crowdbrush render SCENE --output FILE.png\" works without one.\n",
                   stderr);
        return 1;
    }
    // Re-docking would re-create the viewport's context otherwise; strokes want every event.
    QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
    QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("Crowdbrush"));
    QApplication::setApplicationName(QStringLiteral("Crowdbrush"));
    QApplication::setApplicationVersion(QStringLiteral(CROWD_VERSION));
    QApplication::setWindowIcon(widgets::iconNamed("crowdbrush"));
    loadTranslation(application);
    widgets::applyTheme(Preferences::load().theme); // icons take their colour when they are made
    MainWindow window;
    window.show();
    QMetaObject::invokeMethod(
        &window, [&window, files] { openFiles(window, files); }, Qt::QueuedConnection);
    return QApplication::exec();
}

} // namespace crowd::app
