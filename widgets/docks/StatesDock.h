// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QTimer>

#include "model/population/ColumnSet.h"
#include "model/scene/State.h"
#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QListWidgetItem;
class QMenu;
class QToolButton;

namespace crowd::widgets {

class RecallForm;
class StatePictures;

/// The kept states of the scene, in the order of their keys: a double click recalls one. Below, how
/// it comes, and of whom the next one is and what it holds. Each change is one undo step. Main
/// thread.
class StatesDock : public DockBase
{
    Q_OBJECT

public:
    StatesDock(EditorState& state, QWidget* parent);

private:
    [[nodiscard]] QWidget* buttons();
    [[nodiscard]] QWidget* holding();
    [[nodiscard]] QWidget* difference();
    void refreshDifference();
    void fillReach();
    void addHolds(QMenu& menu, model::StateId id);
    void connectParts();
    void connectKeys();
    void fill();
    void showRow(const model::State& kept, int row);
    void enableRecall();
    void showMenu(const QPoint& position);
    void keep();
    void edit(model::StateId id);
    void recallChosen();
    [[nodiscard]] model::StateId chosen() const; ///< 0: none
    [[nodiscard]] model::ColumnSet ticked() const;
    void showChosen(model::StateId id);
    void chooseForBrush();
    void refreshNotes();

    EditorState& m_state;
    QTimer m_rebuild;
    QTimer m_compare; ///< what is shown with the chosen state
    QTimer m_follow;  ///< the same, while it plays
    // Children of this widget.
    QListWidget* m_list;
    QLabel* m_note;
    QLabel* m_difference;
    QComboBox* m_reach;
    StatePictures* m_pictures;
    std::vector<QCheckBox*> m_aspects; ///< as propertyAspects()
    QWidget* m_chosenButtons = nullptr;
    RecallForm* m_recall = nullptr;
    QToolButton* m_wash = nullptr;
    bool m_isFilling = false;
};

} // namespace crowd::widgets
