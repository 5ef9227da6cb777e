// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtCore/QTimer>

#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QComboBox;
class QFormLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QToolButton;

namespace crowd::widgets {

class BranchList;
class EnvironmentTree;
class NumberField;

/// Places and paths as a tree, with all values of what is selected below it, and what is wrong with
/// them; every change is one undo step.
class EnvironmentDock : public DockBase
{
    Q_OBJECT

public:
    EnvironmentDock(EditorState& state, QWidget* parent);

private:
    void buildContent();
    void followTree();
    void buildForm();
    void buildNameRow();
    void buildPlaceRows();
    void buildSizeRow();
    void buildShapeRow();
    void showShape(const model::Place& place);
    void buildPathRows();
    void refreshForm();
    void showProblem();
    /// The people whom a problem names.
    void selectTroubled();
    void chooseColor();
    void changePlace(const QString& undoText, const std::function<void(model::Place&)>& change);
    void changePath(const QString& undoText, const std::function<void(model::Path&)>& change);
    [[nodiscard]] const model::Place* place() const;
    [[nodiscard]] const model::Path* path() const;

    EditorState& m_state;
    EnvironmentTree* m_tree;
    QTimer m_scroll; ///< the form below may take room from the tree first
    // Children of this widget.
    QLineEdit* m_name;
    NumberField* m_position[3];
    NumberField* m_radius;
    NumberField* m_capacity;
    NumberField* m_speedShare;
    QComboBox* m_role;
    QComboBox* m_shape;
    QLabel* m_shapeFacts;
    QLabel* m_sizeLabel;
    QComboBox* m_kind;
    QToolButton* m_color;
    QLabel* m_problem;
    BranchList* m_branches;
    QLabel* m_note;
    QFormLayout* m_form;
    // Rows of the form with several fields each.
    QHBoxLayout* m_nameRow;
    QHBoxLayout* m_positionRow;
    bool m_isFilling = false;
};

} // namespace crowd::widgets
