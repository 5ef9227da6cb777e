// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "widgets/docks/DockBase.h"
#include "widgets/forms/HeldEdit.h"
#include "widgets/state/EditorState.h"

class QLabel;
class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace crowd::widgets {

class FieldForm;
class LookPictures;

/// The looks of the scene, with small pictures: the chosen one is that of the view, and all that is
/// described of it can be changed. A drag of a slider is one undo step, and seen while it lasts.
/// Main thread.
class LooksDock : public DockBase
{
    Q_OBJECT

public:
    LooksDock(EditorState& state, QWidget* parent);
    ~LooksDock() override;

private:
    [[nodiscard]] QWidget* makeButtons();
    void fillAddMenu();
    void makeForm();
    void connectParts();
    void fill();
    void markShown();
    void choose(); ///< as the list says
    void takeName(const QListWidgetItem& item);
    void showMenu(const QPoint& position);
    void takeFile();
    void saveShown();
    [[nodiscard]] const model::LookPreset& shown() const; ///< a plain one where there is none
    void change(const std::function<void(void*)>& apply);

    EditorState& m_state;
    HeldEdit m_edit;
    QListWidget* m_list; ///< children, as all below
    QLabel* m_note;
    QToolButton* m_add = nullptr;
    QWidget* m_remove = nullptr;
    FieldForm* m_form = nullptr;
    LookPictures* m_pictures;
    bool m_isFilling = false;
};

} // namespace crowd::widgets
