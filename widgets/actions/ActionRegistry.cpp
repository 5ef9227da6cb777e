// SPDX-License-Identifier: MIT
#include "widgets/actions/ActionRegistry.h"

#include <algorithm>

#include <QtCore/QCoreApplication>
#include <QtCore/QSettings>
#include <QtWidgets/QWidget>

#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

QString settingsKey(const char* id)
{
    return QStringLiteral("shortcuts/") + QLatin1String(id);
}

} // namespace

ActionRegistry::ActionRegistry(QWidget* window) : QObject(window), m_window(window) {}

QList<QKeySequence> ActionRegistry::defaultShortcuts(const ActionSpec& spec)
{
    return QKeySequence::listFromString(QLatin1String(spec.shortcut), QKeySequence::PortableText);
}

QAction* ActionRegistry::add(const ActionSpec& spec, std::function<void(bool)> run,
                             ActionState state)
{
    Q_ASSERT(!m_actions.contains(spec.id));
    auto* action = new QAction(m_window);
    action->setObjectName(QLatin1String(spec.id));
    action->setCheckable(spec.isCheckable);
    action->setIcon(iconNamed(spec.icon));
    loadShortcut(spec, *action);
    setTexts(spec, *action); // which name the keys
    connect(action, &QAction::triggered, this, std::move(run));
    if (state.inputs) {
        refresh(state, *action);
        // What was clicked may not have come about: a chosen tool stays chosen.
        connect(action, &QAction::triggered, this, [state, action] { refresh(state, *action); });
        m_states.emplace_back(std::move(state), action);
    }
    m_window->addAction(action);
    m_specs.push_back(spec);
    m_actions[spec.id] = action;
    return action;
}

void ActionRegistry::refresh(ActionInputs changed)
{
    for (const auto& [state, action] : m_states) {
        if (state.inputs & changed) {
            refresh(state, *action);
        }
    }
}

void ActionRegistry::renewTexts()
{
    for (const ActionSpec& item : m_specs) {
        setTexts(item, *action(item.id));
    }
    for (const auto& [state, action] : m_states) {
        refresh(state, *action);
    }
}

void ActionRegistry::refresh(const ActionState& state, QAction& action)
{
    if (state.isEnabled) {
        action.setEnabled(state.isEnabled());
    }
    if (state.isChecked) {
        action.setChecked(state.isChecked());
    }
    if (state.text) {
        action.setText(state.text());
    }
}

QAction* ActionRegistry::action(const std::string& id) const
{
    const auto found = m_actions.find(id);
    Q_ASSERT_X(found != m_actions.end(), "ActionRegistry", id.c_str());
    return found->second;
}

const ActionSpec& ActionRegistry::spec(const std::string& id) const
{
    return *std::ranges::find_if(m_specs, [&](const ActionSpec& item) { return id == item.id; });
}

void ActionRegistry::setTexts(const ActionSpec& spec, QAction& action)
{
    action.setText(QCoreApplication::translate("Actions", spec.text));
    const QString tip = QCoreApplication::translate("Actions", spec.tip);
    const QList<QKeySequence> keys = action.shortcuts();
    const QString all = QKeySequence::listToString(keys, QKeySequence::NativeText)
                            .replace(QLatin1Char(';'), QLatin1Char(','));
    const QString withKeys = keys.isEmpty() ? tip : QStringLiteral("%1  (%2)").arg(tip, all);
    action.setStatusTip(keys.size() > 1 ? withKeys : tip); // a menu shows the first
    action.setToolTip(withKeys);
}

void ActionRegistry::loadShortcut(const ActionSpec& spec, QAction& action) const
{
    const QVariant stored = QSettings().value(settingsKey(spec.id));
    if (stored.isValid()) {
        action.setShortcut(QKeySequence(stored.toString(), QKeySequence::PortableText));
    } else {
        action.setShortcuts(defaultShortcuts(spec));
    }
}

void ActionRegistry::setShortcut(const std::string& id, const QKeySequence& keys)
{
    const ActionSpec& item = spec(id);
    const QList<QKeySequence> defaults = defaultShortcuts(item);
    const bool isDefault = defaults.isEmpty() ? keys.isEmpty() : defaults.front() == keys;
    if (isDefault) {
        QSettings().remove(settingsKey(item.id));
    } else {
        QSettings().setValue(settingsKey(item.id), keys.toString(QKeySequence::PortableText));
    }
    loadShortcut(item, *action(id));
    setTexts(item, *action(id));
}

QAction* ActionRegistry::actionWithShortcut(const QKeySequence& keys) const
{
    for (const auto& [id, item] : m_actions) {
        if (!keys.isEmpty() && item->shortcuts().contains(keys)) {
            return item;
        }
    }
    return nullptr;
}

} // namespace crowd::widgets
