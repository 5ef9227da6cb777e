// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>

#include "app/window/NumberedActions.h"
#include "widgets/state/EditorState.h"

namespace crowd::app {

/// The first nine states under function keys, which are the same on every keyboard: Shift+F1 to
/// Shift+F9 recall one, with Ctrl too the crowd, or who is selected, is kept as it. Their actions
/// are in the registry as "state-N" and "state-keep-N". Main thread only; state and registry
/// outlive it.
class StateKeys : public QObject
{
    Q_OBJECT

public:
    StateKeys(widgets::EditorState& state, widgets::ActionRegistry& actions, QObject* parent);

    /// Fills two menus whenever they are shown: all states by name, and what can be kept as one.
    void attach(QMenu* recall, QMenu* keep) { m_numbered.attach(recall, keep); }

private:
    [[nodiscard]] QStringList names() const;
    void recall(std::size_t index);
    void keep(std::size_t index);

    widgets::EditorState& m_state;
    NumberedActions m_numbered;
};

/// The keys as they come.
[[nodiscard]] const NumberedKeys& stateKeyTable();

} // namespace crowd::app
