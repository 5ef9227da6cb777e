// SPDX-License-Identifier: MIT
#include "app/commands/CardCommand.h"

#include <array>
#include <cstdio>

#include <QtWidgets/QApplication>

#include "app/window/Language.h"
#include "app/window/PreferencesDialog.h"
#include "app/window/QuickCard.h"
#include "app/window/WindowActions.h"
#include "model/base/Translated.h"
#include "model/project/UserFolder.h"

namespace crowd::app {

int runCard(const CardOptions& options, const std::string& language)
{
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen"); // no window is opened
    }
    // What it says of this machine's desktop is of no account here.
    qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
    int count = 1;
    std::array<char, 11> name{"crowdbrush"};
    std::array<char*, 2> arguments{name.data(), nullptr};
    QApplication application(count, arguments.data());
    QApplication::setOrganizationName(QLatin1String(model::kProgramName));
    QApplication::setApplicationName(QLatin1String(model::kProgramName));
    const Preferences preferences = Preferences::load();
    useLanguage(language.empty() ? preferences.language : QString::fromStdString(language));
    QWidget window; // that actions belong to; it is not shown
    widgets::ActionRegistry actions(&window);
    addActionsAlone(actions);
    const auto written = writeCard(cardSections(actions, preferences.buttons),
                                   QString::fromLocal8Bit(options.output.c_str()));
    if (!written) {
        std::fprintf(stderr, "crowdbrush card: %s\n", written.error().message.c_str());
        return 1;
    }
    return 0;
}

} // namespace crowd::app
