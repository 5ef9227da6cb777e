// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <vector>

#include <QtCore/QTimer>
#include <QtGui/QColor>
#include <QtGui/QIcon>

#include "behavior/session/SessionTally.h"
#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QComboBox;
class QFormLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace crowd::widgets {

class BranchList;
class NumberField;

/// Places and paths as a tree, with all their values below it. What is selected here is selected
/// in the picture and the other way round; every change is one undo step. While a session runs, its
/// people are counted.
class EnvironmentDock : public DockBase
{
    Q_OBJECT

public:
    EnvironmentDock(EditorState& state, QWidget* parent);

private:
    /// Of items in the tree, and where the place of a path is in it.
    enum ItemType { KindItem = 1001, PathItem, PlaceItem };
    static constexpr int kIndexRole = Qt::UserRole + 1;

    /// What the tree last scrolled to: the path, the places, and how many places it has.
    struct Shown
    {
        model::PathId path = 0;
        std::vector<model::PlaceId> places;
        int length = 0;
        friend bool operator==(const Shown&, const Shown&) = default;
    };
    static constexpr QColor kTroubleColor{208, 80, 64};
    [[nodiscard]] static QIcon colorIcon(const std::array<std::uint8_t, 3>& color);

    void buildContent();
    void followScene();
    void followTree();
    void followSession();
    void buildForm();
    void buildNameRow();
    void buildPlaceRows();
    void buildSizeRow();
    void buildPathRows();
    void rebuild();
    void addPaths();
    void addPlaces();
    static QTreeWidgetItem* addPlace(QTreeWidgetItem& parent, const model::Place& place);
    [[nodiscard]] behavior::SessionTally tally() const;
    void showCounts();
    void showSelection();
    void scrollToSelection();
    void takeSelection();
    void refreshForm();
    [[nodiscard]] QString problemOf(const QTreeWidgetItem& item) const;
    void showProblems();
    /// The people whom a problem names.
    void selectTroubled();
    void rename(QTreeWidgetItem* item);
    void showMenu(const QPoint& position);
    void chooseColor();
    void changePlace(const QString& undoText, const std::function<void(model::Place&)>& change);
    void changePath(const QString& undoText, const std::function<void(model::Path&)>& change);
    [[nodiscard]] const model::Place* place() const;
    [[nodiscard]] const model::Path* path() const;

    EditorState& m_state;
    QTreeWidget* m_tree;
    QTimer m_rebuild;
    QTimer m_scroll;                ///< the form below may take room from the tree first
    QTimer m_count;                 ///< until people of the session are counted again
    double m_countedSeconds = -1.0; ///< of the session, when they last were
    behavior::SessionTally m_tally; ///< as the tree shows it
    Shown m_shown;
    // Children of this widget.
    QLineEdit* m_name;
    NumberField* m_position[3];
    NumberField* m_radius;
    NumberField* m_capacity;
    NumberField* m_speedShare;
    QComboBox* m_role;
    QComboBox* m_kind;
    QToolButton* m_color;
    QLabel* m_problem;
    BranchList* m_branches;
    QLabel* m_note;
    QFormLayout* m_form;
    // Rows of the form with several fields each.
    QHBoxLayout* m_nameRow;
    QHBoxLayout* m_positionRow;
    QHBoxLayout* m_sizeRow;
    bool m_isFilling = false;
};

} // namespace crowd::widgets
