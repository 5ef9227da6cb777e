// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QTimer>

#include "model/scene/Take.h"
#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QLabel;
class QListWidget;
class QToolButton;

namespace crowd::widgets {

class HandEditsPanel;
class TakeFigures;

/// The kept takes of the scene below the scene itself as it plays: a double click shows one.
/// Another one can be seen beside it as ghosts, and in figures. Main thread.
class TakesDock : public DockBase
{
    Q_OBJECT

public:
    TakesDock(EditorState& state, QWidget* parent);

private:
    [[nodiscard]] QWidget* buttons();
    void connectParts();
    void fill();
    void addRow(const QString& text, const QString& tip, model::TakeId id, bool isShown);
    void addTake(const model::Take& take);
    void refreshButtons();
    void refreshNote();
    void refreshDifference();
    void showMenu(const QPoint& position);
    void sayRetaken(const QString& name, int people, double furthestMetres);
    void showChosen();
    void removeChosen();
    [[nodiscard]] int rowOf(model::TakeId id) const;
    [[nodiscard]] model::TakeId chosen() const; ///< 0: none, or the scene as it plays

    EditorState& m_state;
    QTimer m_follow; ///< figures, while it plays
    // Children of this widget.
    QListWidget* m_list;
    QLabel* m_note;
    QLabel* m_difference;
    TakeFigures* m_figures;
    HandEditsPanel* m_edits;
    QToolButton* m_keep = nullptr;
    QToolButton* m_show = nullptr;
    QToolButton* m_ghost = nullptr;
    QToolButton* m_goOn = nullptr;
    QToolButton* m_retake = nullptr;
    model::TakeId m_shown = 0; ///< when the list was filled last
    QToolButton* m_remove = nullptr;
    bool m_isFilling = false;
};

} // namespace crowd::widgets
