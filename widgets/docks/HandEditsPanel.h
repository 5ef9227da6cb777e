// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <QtWidgets/QWidget>

#include "model/scene/HandEdit.h"
#include "widgets/forms/HeldEdit.h"
#include "widgets/state/EditorState.h"

class QCheckBox;
class QListWidget;
class QToolButton;

namespace crowd::widgets {

class FieldForm;

/// What is done by hand to people of the take that is shown: a list of edits that can be switched
/// off, and what the chosen one says. Hidden where no take is shown. Main thread.
class HandEditsPanel : public QWidget
{
    Q_OBJECT

public:
    HandEditsPanel(EditorState& state, QWidget* parent);

    /// Another take is shown, or its edits are others.
    void refresh();
    [[nodiscard]] QListWidget* list() const { return m_list; }
    void removeChosen();

private:
    [[nodiscard]] QWidget* buttons();
    void fillMenu();
    void makeForm();
    void connectParts();
    void fill(const std::vector<model::HandEdit>& edits);
    void refreshButtons();
    void change(const std::function<void(void*)>& apply);
    [[nodiscard]] const model::HandEdit& shown() const;
    [[nodiscard]] const std::vector<model::HandEdit>& edits() const;

    EditorState& m_state;
    HeldEdit m_edit;
    // Children of this widget.
    QCheckBox* m_areOn;
    QListWidget* m_list;
    FieldForm* m_form = nullptr;
    QToolButton* m_add = nullptr;
    QToolButton* m_select = nullptr;
    QToolButton* m_remove = nullptr;
    bool m_isFilling = false;
};

} // namespace crowd::widgets
