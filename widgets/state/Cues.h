// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>

#include "widgets/state/EditorState.h"

class QShortcut;
class QWidget;

namespace crowd::widgets {

/// What a cue without a name is called after: its event, or the state that people take on.
[[nodiscard]] QString cueTitle(const model::Scene& scene, const model::Cue& cue);
/// Lets a cue speak to the running session, and people take on its state there; says in the status
/// line what became of it.
void sendCue(EditorState& state, const model::Cue& cue);

/// The cues' keys in a window: they work wherever no text is being typed. Owned by the window.
class CueKeys : public QObject
{
    Q_OBJECT

public:
    CueKeys(EditorState& state, QWidget* window);

private:
    void rebuild();

    EditorState& m_state;
    QWidget* m_window;
    std::vector<QShortcut*> m_shortcuts; ///< children of the window
};

} // namespace crowd::widgets
