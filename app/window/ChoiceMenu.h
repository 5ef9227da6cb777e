// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtCore/QString>

class QActionGroup;
class QMenu;

namespace crowd::app {

/// One of several things of which one holds.
struct MenuChoice
{
    QString name; ///< of the action, for tests and keys
    QString text;
    QString tip{}; ///< in the status bar
    std::function<void()> choose;
    std::function<bool()> isChosen;
};

/// Adds choices to a menu, which shows the one that holds whenever it opens. They are the menu's.
class ChoiceMenu
{
public:
    explicit ChoiceMenu(QMenu& menu);

    void add(const MenuChoice& choice);

private:
    QMenu& m_menu;
    QActionGroup* m_group; ///< child of the menu
};

} // namespace crowd::app
