// SPDX-License-Identifier: MIT
#include "app/window/LookMenu.h"

#include <QtCore/QCoreApplication>
#include <QtWidgets/QMenu>

#include "app/window/ChoiceMenu.h"
#include "render/Looks.h"
#include "widgets/state/EditorState.h"
#include "widgets/state/ShownLook.h"

namespace crowd::app {

namespace {

/// Those that are the scene's, below the styles, as they are now.
void fillSceneLooks(QMenu& menu, widgets::EditorState& state)
{
    const QString name = QStringLiteral("scene-look");
    qDeleteAll(menu.findChildren<QAction*>(name, Qt::FindDirectChildrenOnly));
    if (state.scene().looks.empty()) {
        return;
    }
    menu.addSeparator()->setObjectName(name);
    for (const model::LookPreset& look : state.scene().looks) {
        QString text = QString::fromStdString(look.name);
        text.replace(QLatin1Char('&'), QLatin1String("&&")); // it marks no key here
        QAction* action = menu.addAction(text);
        action->setObjectName(name);
        action->setCheckable(true);
        action->setChecked(widgets::shownLook(state) == &look);
        QObject::connect(action, &QAction::triggered, &state,
                         [&state, id = look.id] { widgets::showLook(state, id); });
    }
}

} // namespace

void fillLookMenu(QMenu& menu, widgets::EditorState& state)
{
    ChoiceMenu choices(menu);
    QObject::connect(&menu, &QMenu::aboutToShow, &state,
                     [&menu, &state] { fillSceneLooks(menu, state); });
    for (const render::LookInfo& info : render::kLooks) {
        choices.add({.name = QStringLiteral("look-choice-") + QLatin1String(info.key),
                     .text = QCoreApplication::translate("Looks", info.label),
                     .tip = QCoreApplication::translate("Looks", info.tip),
                     .choose =
                         [&state, look = info.look] {
                             widgets::ViewOptions options = state.viewOptions();
                             options.look = look;
                             options.ownLook = 0;
                             state.setViewOptions(options);
                         },
                     .isChosen =
                         [&state, look = info.look] {
                             return state.viewOptions().look == look &&
                                    widgets::shownLook(state) == nullptr;
                         }});
    }
}

} // namespace crowd::app
