// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "model/scene/Timeline.h"
#include "widgets/docks/DockBase.h"
#include "widgets/forms/HeldEdit.h"
#include "widgets/state/EditorState.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace crowd::widgets {

class FieldForm;
class TimelineView;

/// What happens when while it plays: the timeline as a picture, and beside it all that can be set
/// of the mark that is chosen. While it records, what is performed becomes marks. Main thread.
class TimelineDock : public DockBase
{
    Q_OBJECT

public:
    TimelineDock(EditorState& state, QWidget* parent);

    void takeOver(DockBase& before) override;

private:
    [[nodiscard]] QWidget* makeButtons();
    [[nodiscard]] QWidget* makeHalves();
    [[nodiscard]] QWidget* makeSide();
    using AddButton =
        std::function<QToolButton*(const char* icon, const QString& tip, const char* name)>;
    void addRangeButtons(const AddButton& add);
    void addFollow(QToolButton& button);
    void makeUnits();
    void makeForm();
    void followChosen();
    void describe();
    [[nodiscard]] QString flaws() const;
    void followLoop();
    [[nodiscard]] const model::Mark& shown() const; ///< a plain one where none is chosen
    void change(const std::function<void(void*)>& apply);

    EditorState& m_state;
    HeldEdit m_edit;
    TimelineView* m_view; ///< children, as all below
    QComboBox* m_units;
    QToolButton* m_record = nullptr;
    QToolButton* m_loop = nullptr;
    QToolButton* m_remove = nullptr;
    QWidget* m_side = nullptr; ///< what the form and the note are in
    QLabel* m_note;
    FieldForm* m_form = nullptr;
};

} // namespace crowd::widgets
