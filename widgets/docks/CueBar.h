// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtWidgets/QWidget>

#include "widgets/state/EditorState.h"

class QGridLayout;

namespace crowd::widgets {

/// The scene's cues as buttons: a click lets the event happen. They are added, changed and deleted
/// here, each as one undo step.
class CueBar : public QWidget
{
    Q_OBJECT

public:
    CueBar(EditorState& state, QWidget* parent);

private:
    void rebuild();
    void addCue();
    void editCue(model::CueId id);
    void removeCue(model::CueId id);
    void showMenu(model::CueId id, const QPoint& globalPosition);
    void setCues(std::vector<model::Cue> cues, const QString& undoText);
    [[nodiscard]] QWidget* buttonOf(const model::Cue& cue);

    EditorState& m_state;
    QGridLayout* m_grid; ///< owned by this widget
};

} // namespace crowd::widgets
