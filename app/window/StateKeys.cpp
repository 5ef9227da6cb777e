// SPDX-License-Identifier: MIT
#include "app/window/StateKeys.h"

#include "model/states/StateKeeping.h"
#include "widgets/commands/StateCommands.h"

namespace crowd::app {

namespace {

constexpr NumberedKeys kStateKeys{{
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

constexpr const char* kRecallTip = QT_TRANSLATE_NOOP(
    "Actions", "Give everybody back what he had in the state of this number: while "
               "it plays in this run alone, else in the scene");
constexpr const char* kKeepStateTip = QT_TRANSLATE_NOOP(
    "Actions", "Keep how the crowd is now, or who is selected, as the state of this number");

} // namespace

StateKeys::StateKeys(widgets::EditorState& state, widgets::ActionRegistry& actions, QObject* parent)
    : QObject(parent), m_state(state),
      m_numbered(actions, kStateKeys,
                 {"state", kRecallTip, "state-add", kKeepStateTip, [this] { return names(); },
                  [this](std::size_t index) { recall(index); },
                  [this](std::size_t index) { keep(index); },
                  [] { return tr("The scene has no states yet"); }, [] { return tr("New State"); }},
                 nullptr)
{
}

QStringList StateKeys::names() const
{
    QStringList names;
    for (const model::State& each : m_state.scene().states) {
        names << QString::fromStdString(each.name);
    }
    return names;
}

void StateKeys::recall(std::size_t index)
{
    const auto& states = m_state.scene().states;
    if (index < states.size()) {
        widgets::recallStateOf(m_state, states[index].id, widgets::RecallInto::Run);
        return;
    }
    m_state.showStatus(tr("The scene has no state %1. %2 keeps the crowd as one.")
                           .arg(index + 1)
                           .arg(m_numbered.keepShortcut(index)));
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
    const QString name = widgets::freeStateName(m_state.scene());
    const std::size_t place = states.size(); // keys count the states that there are
    if (widgets::keepStateAs(m_state, name, model::usualStateColumns(), reach) && place != index) {
        m_state.showStatus(tr("“%1” keeps how they are now; it is number %2 of the states: %3 "
                              "recalls it")
                               .arg(name)
                               .arg(place + 1)
                               .arg(m_numbered.goToShortcut(place)));
    }
}

const NumberedKeys& stateKeyTable()
{
    return kStateKeys;
}

} // namespace crowd::app
