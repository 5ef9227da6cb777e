// SPDX-License-Identifier: MIT
#include "app/window/LookMenu.h"

#include <QtCore/QCoreApplication>
#include <QtGui/QActionGroup>
#include <QtWidgets/QMenu>

#include "render/Looks.h"
#include "widgets/state/EditorState.h"

namespace crowd::app {

void fillLookMenu(QMenu& menu, widgets::EditorState& state)
{
    auto* group = new QActionGroup(&menu);
    for (const render::LookInfo& info : render::kLooks) {
        QAction* action = menu.addAction(QString());
        action->setObjectName(QStringLiteral("look-choice-") + QLatin1String(info.key));
        action->setCheckable(true);
        group->addAction(action);
        QObject::connect(action, &QAction::triggered, &menu, [&state, look = info.look] {
            widgets::ViewOptions options = state.viewOptions();
            options.look = look;
            state.setViewOptions(options);
        });
    }
    QObject::connect(&menu, &QMenu::aboutToShow, &menu, [&menu, &state] {
        std::size_t i = 0;
        for (QAction* action : menu.actions()) {
            const render::LookInfo& info = render::kLooks.at(i++);
            action->setText(QCoreApplication::translate("Looks", info.label));
            action->setStatusTip(QCoreApplication::translate("Looks", info.tip));
            action->setChecked(state.viewOptions().look == info.look);
        }
    });
}

} // namespace crowd::app
