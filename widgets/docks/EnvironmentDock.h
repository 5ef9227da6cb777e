// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtCore/QTimer>

#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QMenu;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace crowd::widgets {

class BranchList;
class NumberField;

/// Places and paths as a tree, with all their values below it. What is selected here is selected
/// in the picture and the other way round; every change is one undo step.
class EnvironmentDock : public DockBase
{
    Q_OBJECT

public:
    EnvironmentDock(EditorState& state, QWidget* parent);

private:
    /// Of items in the tree, and where the place of a path is in it.
    enum ItemType { KindItem = 1001, PathItem, PlaceItem };
    static constexpr int kIndexRole = Qt::UserRole + 1;

    void buildForm(QFormLayout* form);
    void rebuild();
    void addPaths();
    void addPlaces();
    void showSelection();
    void takeSelection();
    void refreshForm();
    [[nodiscard]] QString problemOf(const QTreeWidgetItem& item) const;
    void showProblems();
    void rename(QTreeWidgetItem* item);
    void showMenu(const QPoint& position);
    void fillPathMenu(QMenu& menu, model::PathId path);
    void fillPlaceMenu(QMenu& menu, QTreeWidgetItem* item);
    void chooseColor();
    void assignSelected(model::PathId path);
    void selectPeopleOf(model::PathId path);
    void changePlace(const QString& undoText, const std::function<void(model::Place&)>& change);
    void changePath(const QString& undoText, const std::function<void(model::Path&)>& change);
    [[nodiscard]] const model::Place* place() const;
    [[nodiscard]] const model::Path* path() const;

    EditorState& m_state;
    QTreeWidget* m_tree;
    QTimer m_rebuild;
    // Children of this widget.
    QLineEdit* m_name;
    NumberField* m_position[3];
    NumberField* m_radius;
    NumberField* m_capacity;
    NumberField* m_speedShare;
    QComboBox* m_role;
    QComboBox* m_kind;
    QToolButton* m_color;
    QLabel* m_people;
    QLabel* m_problem;
    BranchList* m_branches;
    QLabel* m_note;
    QFormLayout* m_form;
    bool m_isFilling = false;
};

} // namespace crowd::widgets
