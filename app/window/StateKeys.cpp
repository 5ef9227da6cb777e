// SPDX-License-Identifier: MIT
#include "app/window/StateKeys.h"

#include <algorithm>
#include <array>

#include <QtWidgets/QMenu>

#include "model/states/StateKeeping.h"
#include "widgets/commands/StateCommands.h"

namespace crowd::app {

namespace {

constexpr std::size_t kStateKeys = 9;

struct StateKey
{
    const char* recall;
    const char* recallText;
    const char* recallKeys;
    const char* keep;
    const char* keepText;
    const char* keepKeys;
};

constexpr std::array<StateKey, kStateKeys> kKeys{{
    {"state-1", QT_TRANSLATE_NOOP("Actions", "Recall State &1"), "Shift+F1", "state-keep-1",
     QT_TRANSLATE_NOOP("Actions", "Keep State &1"), "Ctrl+Shift+F1"},
    {"state-2", QT_TRANSLATE_NOOP("Actions", "Recall State &2"), "Shift+F2", "state-keep-2",
     QT_TRANSLATE_NOOP("Actions", "Keep State &2"), "Ctrl+Shift+F2"},
    {"state-3", QT_TRANSLATE_NOOP("Actions", "Recall State &3"), "Shift+F3", "state-keep-3",
     QT_TRANSLATE_NOOP("Actions", "Keep State &3"), "Ctrl+Shift+F3"},
    {"state-4", QT_TRANSLATE_NOOP("Actions", "Recall State &4"), "Shift+F4", "state-keep-4",
     QT_TRANSLATE_NOOP("Actions", "Keep State &4"), "Ctrl+Shift+F4"},
    {"state-5", QT_TRANSLATE_NOOP("Actions", "Recall State &5"), "Shift+F5", "state-keep-5",
     QT_TRANSLATE_NOOP("Actions", "Keep State &5"), "Ctrl+Shift+F5"},
    {"state-6", QT_TRANSLATE_NOOP("Actions", "Recall State &6"), "Shift+F6", "state-keep-6",
     QT_TRANSLATE_NOOP("Actions", "Keep State &6"), "Ctrl+Shift+F6"},
    {"state-7", QT_TRANSLATE_NOOP("Actions", "Recall State &7"), "Shift+F7", "state-keep-7",
     QT_TRANSLATE_NOOP("Actions", "Keep State &7"), "Ctrl+Shift+F7"},
    {"state-8", QT_TRANSLATE_NOOP("Actions", "Recall State &8"), "Shift+F8", "state-keep-8",
     QT_TRANSLATE_NOOP("Actions", "Keep State &8"), "Ctrl+Shift+F8"},
    {"state-9", QT_TRANSLATE_NOOP("Actions", "Recall State &9"), "Shift+F9", "state-keep-9",
     QT_TRANSLATE_NOOP("Actions", "Keep State &9"), "Ctrl+Shift+F9"},
}};

constexpr const char* kRecallTip =
    QT_TRANSLATE_NOOP("Actions", "Give everybody back what he had in the state of this number");
constexpr const char* kKeepStateTip = QT_TRANSLATE_NOOP(
    "Actions", "Keep how the crowd is now, or who is selected, as the state of this number");

QString numberedState(std::size_t index, QString name)
{
    return QStringLiteral("&%1  %2").arg(index + 1).arg(
        name.replace(QLatin1Char('&'), QLatin1String("&&")));
}

} // namespace

StateKeys::StateKeys(widgets::EditorState& state, widgets::ActionRegistry& actions, QObject* parent)
    : QObject(parent), m_state(state), m_actions(actions)
{
    for (std::size_t i = 0; i < kStateKeys; ++i) {
        const StateKey& key = kKeys[i];
        m_actions.add({key.recall, key.recallText, "state", key.recallKeys, kRecallTip},
                      [this, i](bool) { recall(i); });
        m_actions.add({key.keep, key.keepText, "state-add", key.keepKeys, kKeepStateTip},
                      [this, i](bool) { keep(i); });
    }
}

void StateKeys::recall(std::size_t index)
{
    const auto& states = m_state.scene().states;
    if (index < states.size()) {
        widgets::recallStateOf(m_state, states[index].id);
        return;
    }
    m_state.showStatus(tr("The scene has no state %1. %2 keeps the crowd as one.")
                           .arg(index + 1)
                           .arg(m_actions.action(kKeys[index].keep)
                                    ->shortcut()
                                    .toString(QKeySequence::NativeText)));
}

void StateKeys::keep(std::size_t index)
{
    const auto& states = m_state.scene().states;
    if (index < states.size()) {
        widgets::keepStateAnew(m_state, states[index].id);
        return;
    }
    const auto reach = m_state.selection().ids().empty() ? widgets::StateReach::Everybody
                                                         : widgets::StateReach::Selected;
    (void)widgets::keepStateAs(m_state, widgets::freeStateName(m_state.scene()),
                               model::usualStateColumns(), reach);
}

void StateKeys::attach(QMenu* recall, QMenu* keep)
{
    connect(recall, &QMenu::aboutToShow, this, [this, recall] { fillRecall(recall); });
    connect(keep, &QMenu::aboutToShow, this, [this, keep] { fillKeep(keep); });
    fillRecall(recall);
    fillKeep(keep);
}

void StateKeys::fillRecall(QMenu* menu)
{
    menu->clear();
    const auto& states = m_state.scene().states;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const QString name = QString::fromStdString(states[i].name);
        if (i < kStateKeys) {
            QAction* action = m_actions.action(kKeys[i].recall);
            action->setText(numberedState(i, name));
            menu->addAction(action);
        } else {
            connect(menu->addAction(name), &QAction::triggered, this,
                    [this, id = states[i].id] { widgets::recallStateOf(m_state, id); });
        }
    }
    if (states.empty()) {
        menu->addAction(tr("The scene has no states yet"))->setEnabled(false);
    }
}

void StateKeys::fillKeep(QMenu* menu)
{
    menu->clear();
    const auto& states = m_state.scene().states;
    for (std::size_t i = 0; i < std::min(states.size() + 1, kStateKeys); ++i) {
        QAction* action = m_actions.action(kKeys[i].keep);
        const bool isNew = i == states.size();
        action->setText(
            numberedState(i, isNew ? tr("New State") : QString::fromStdString(states[i].name)));
        menu->addAction(action);
    }
}

} // namespace crowd::app
