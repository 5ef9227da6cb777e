// SPDX-License-Identifier: MIT
#include "app/commands/EditorCommand.h"

#include <cstdio>

#include <QtWidgets/QApplication>

#include "app/window/Language.h"
#include "app/window/MainWindow.h"
#include "app/window/PreferencesDialog.h"
#include "model/project/UserFolder.h"
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

} // namespace

int runEditor(int& argc, char** argv, const QStringList& files, const QString& language)
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
    QApplication::setOrganizationName(QLatin1String(model::kProgramName));
    QApplication::setApplicationName(QLatin1String(model::kProgramName));
    QApplication::setApplicationVersion(QStringLiteral(CROWD_VERSION));
    QApplication::setWindowIcon(widgets::iconNamed("crowdbrush"));
    useLanguage(language.isEmpty() ? Preferences::load().language : language);
    widgets::applyTheme(Preferences::load().theme); // icons take their colour when they are made
    MainWindow window;
    window.show();
    QMetaObject::invokeMethod(
        &window, [&window, files] { window.start(files); }, Qt::QueuedConnection);
    return QApplication::exec();
}

} // namespace crowd::app
