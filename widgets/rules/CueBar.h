// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <QtWidgets/QWidget>

#include "widgets/state/EditorState.h"

class QGridLayout;
class QMenu;

namespace crowd::widgets {

/// The scene's cues as buttons: a click lets the event happen. They are added, changed in a form
/// below the buttons and deleted here, each change as one undo step.
class CueBar : public QWidget
{
    Q_OBJECT

public:
    CueBar(EditorState& state, QWidget* parent);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void rebuild();
    void arrange();
    void addCue();
    void editCue(model::CueId id);
    void removeCue(model::CueId id);
    void showForm();
    void change(const std::function<void(model::Cue&)>& apply);
    [[nodiscard]] QMenu* menuOf(model::CueId id, QWidget* parent);
    void setCues(std::vector<model::Cue> cues, const QString& undoText);
    [[nodiscard]] QWidget* buttonOf(const model::Cue& cue);

    EditorState& m_state;
    model::CueId m_edited = 0; ///< whose form is open
    // Children of this widget.
    QGridLayout* m_grid;
    std::vector<QWidget*> m_buttons; ///< of the cues
    QWidget* m_add = nullptr;
    QWidget* m_form = nullptr;
    int m_inARow = 0;
};

} // namespace crowd::widgets
