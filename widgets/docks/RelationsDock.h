// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtCore/QTimer>

#include "model/scene/Relation.h"
#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QCheckBox;
class QLabel;
class QListWidget;
class QMenu;
class QVBoxLayout;

namespace crowd::widgets {

class FieldForm;

/// Kinds of relations, how many there are of each, and what each does; commands for those who are
/// selected. Each change is an undo step. Main thread.
class RelationsDock : public DockBase
{
    Q_OBJECT

public:
    RelationsDock(EditorState& state, QWidget* parent);

private:
    [[nodiscard]] QWidget* buttons();
    void connectParts();
    void connectList();
    void fill();
    void addRow(const model::RelationKind& kind);
    [[nodiscard]] static QString tipFor(int number); ///< so many relations
    void count();
    void showKind();
    void chooseForBrush();
    void paintChosen(); ///< its brush in hand
    void followBrush();
    [[nodiscard]] int rowOfBrush() const;
    void makeForm();
    void showMenu(const QPoint& position);
    void fillMenu(QMenu& menu, model::RelationKindId id);
    void edit(model::RelationKindId id);
    void change(const std::function<void(void*)>& apply);
    [[nodiscard]] model::RelationKindId chosenId() const;
    [[nodiscard]] const model::RelationKind* chosen() const; ///< null: none

    EditorState& m_state;
    QTimer m_rebuild;
    QTimer m_count;
    bool m_isFilling = false;
    // Children of this widget.
    QCheckBox* m_shows;
    QListWidget* m_kinds;
    QLabel* m_note;
    QWidget* m_chosenButtons = nullptr;
    QVBoxLayout* m_formPlace;
    FieldForm* m_form = nullptr;
};

} // namespace crowd::widgets
