// SPDX-License-Identifier: MIT
#include "app/commands/EditorCommand.h"

#include <cstdio>

#include <QtCore/QLibraryInfo>
#include <QtCore/QLocale>
#include <QtCore/QTranslator>
#include <QtWidgets/QApplication>

#include "app/window/MainWindow.h"
#include "app/window/PreferencesDialog.h"
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

/// Qt's own words: buttons of its dialogs, names of keys. They come with the system.
void loadQtTranslation(QApplication& application, const QLocale& locale)
{
    auto* translator = new QTranslator(&application);
    if (translator->load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
                         QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
        QApplication::installTranslator(translator);
    }
}

/// Words, and numbers in fields, of the language that was chosen. Files know no language.
void loadTranslation(QApplication& application)
{
    const QString chosen = Preferences::load().language;
    const QLocale locale = chosen.isEmpty() ? QLocale::system() : QLocale(chosen);
    QLocale::setDefault(locale);
    loadQtTranslation(application, locale);
    auto* translator = new QTranslator(&application);
    if (translator->load(locale, QStringLiteral("crowdbrush"), QStringLiteral("_"),
                         QStringLiteral(":/translations")) ||
        translator->load(QStringLiteral(":/translations/crowdbrush_en.qm"))) {
        QApplication::installTranslator(translator);
    }
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
        &window, [&window, files] { window.start(files); }, Qt::QueuedConnection);
    return QApplication::exec();
}

} // namespace crowd::app
