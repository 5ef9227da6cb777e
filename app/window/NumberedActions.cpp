// SPDX-License-Identifier: MIT
#include "app/window/NumberedActions.h"

#include <algorithm>
#include <utility>

#include <QtWidgets/QMenu>

namespace crowd::app {

namespace {

QString numbered(std::size_t index, QString name)
{
    return QStringLiteral("&%1  %2").arg(index + 1).arg(
        name.replace(QLatin1Char('&'), QLatin1String("&&")));
}

} // namespace

NumberedActions::NumberedActions(widgets::ActionRegistry& actions, const NumberedKeys& keys,
                                 NumberedThings things, QObject* parent)
    : QObject(parent), m_actions(actions), m_keys(keys), m_things(std::move(things))
{
    for (std::size_t i = 0; i < kNumberedKeys; ++i) {
        const NumberedKey& key = m_keys[i];
        m_actions.add({key.go, key.goText, m_things.goIcon, key.goKeys, m_things.goTip},
                      [this, i](bool) { m_things.go(i); });
        m_actions.add({key.keep, key.keepText, m_things.keepIcon, key.keepKeys, m_things.keepTip},
                      [this, i](bool) { m_things.keep(i); });
    }
}

QString NumberedActions::keepShortcut(std::size_t index) const
{
    return m_actions.action(m_keys[index].keep)->shortcut().toString(QKeySequence::NativeText);
}

QString NumberedActions::goToShortcut(std::size_t index) const
{
    return m_actions.action(m_keys[index].go)->shortcut().toString(QKeySequence::NativeText);
}

void NumberedActions::attach(QMenu* goTo, QMenu* keep)
{
    connect(goTo, &QMenu::aboutToShow, this, [this, goTo] { fillGoTo(goTo); });
    connect(keep, &QMenu::aboutToShow, this, [this, keep] { fillKeep(keep); });
    fillGoTo(goTo);
    fillKeep(keep);
}

void NumberedActions::fillGoTo(QMenu* menu)
{
    menu->clear();
    const QStringList names = m_things.names();
    for (int i = 0; i < names.size(); ++i) {
        const auto index = static_cast<std::size_t>(i);
        if (index < kNumberedKeys) {
            QAction* action = m_actions.action(m_keys[index].go);
            action->setText(numbered(index, names[i]));
            menu->addAction(action);
        } else {
            connect(menu->addAction(names[i]), &QAction::triggered, this,
                    [this, index] { m_things.go(index); });
        }
    }
    if (names.isEmpty()) {
        menu->addAction(m_things.none())->setEnabled(false);
    }
}

void NumberedActions::fillKeep(QMenu* menu)
{
    menu->clear();
    const QStringList names = m_things.names();
    const auto count = static_cast<std::size_t>(names.size());
    for (std::size_t i = 0; i < std::min(count + 1, kNumberedKeys); ++i) {
        QAction* action = m_actions.action(m_keys[i].keep);
        action->setText(numbered(i, i == count ? m_things.fresh() : names[static_cast<int>(i)]));
        menu->addAction(action);
    }
}

} // namespace crowd::app
