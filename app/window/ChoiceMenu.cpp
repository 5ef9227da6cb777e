// SPDX-License-Identifier: MIT
#include "app/window/ChoiceMenu.h"

#include <QtGui/QActionGroup>
#include <QtWidgets/QMenu>

namespace crowd::app {

ChoiceMenu::ChoiceMenu(QMenu& menu) : m_menu(menu), m_group(new QActionGroup(&menu)) {}

void ChoiceMenu::add(const MenuChoice& choice)
{
    QAction* action = m_menu.addAction(choice.text);
    action->setObjectName(choice.name);
    action->setStatusTip(choice.tip);
    action->setCheckable(true);
    action->setChecked(choice.isChosen());
    m_group->addAction(action);
    QObject::connect(action, &QAction::triggered, &m_menu, choice.choose);
    QObject::connect(&m_menu, &QMenu::aboutToShow, action,
                     [action, isChosen = choice.isChosen] { action->setChecked(isChosen()); });
}

} // namespace crowd::app
