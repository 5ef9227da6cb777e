// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtCore/QTimer>

#include "widgets/docks/DockBase.h"
#include "widgets/rules/RuleCommands.h"
#include "widgets/rules/RuleLog.h"
#include "widgets/state/EditorState.h"

class QBoxLayout;
class QCheckBox;
class QLabel;
class QListWidget;
class QPlainTextEdit;
class QScrollArea;
class QVBoxLayout;

namespace crowd::widgets {

class CueBar;
class RuleEditor;

/// The rules of the scene as sentences, the first ones the most important; the chosen one is built
/// from menus below. Counts how often each fires while it plays and keeps a log. Every change is
/// one undo step.
class RulesDock : public DockBase
{
    Q_OBJECT

public:
    RulesDock(EditorState& state, QWidget* parent);

    void takeOver(DockBase& before) override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void buildContent();
    void addColumn(const std::function<void(QVBoxLayout&)>& fill);
    void addLog(QVBoxLayout& layout, QWidget* content);
    void arrangeColumns();
    void scrollEditorAlone(bool isAlone);
    void showAdded(const model::Rule& rule);
    void setUpList();
    void addNotes(QVBoxLayout& layout);
    void connectTimers();
    void connectState();
    void connectList();
    void showMenu(const QPoint& position);
    void rebuildList();
    void fitList();
    void rebuildEditor();
    [[nodiscard]] qsizetype focusedField() const;
    void refreshCounts();
    [[nodiscard]] QString problemOf(const model::Rule& rule) const;
    void showProblems();
    void takeOrder();
    void showLog();
    void forgetLog();

    EditorState& m_state;
    QTimer m_rebuild;
    QTimer m_fit;
    QTimer m_counting;
    bool m_isFilling = false;
    // Children of this widget.
    QBoxLayout* m_columns = nullptr;
    QListWidget* m_list;
    CueBar* m_cues = nullptr;
    RuleCommands* m_commands;
    QLabel* m_note;
    QScrollArea* m_editorScroll;
    QWidget* m_editorArea;
    RuleEditor* m_editor = nullptr;
    model::Rule m_edited; ///< as the editor showed it last
    QLabel* m_problem;
    QCheckBox* m_onlySelected;
    QPlainTextEdit* m_log;
    RuleLog m_fired;
    std::uint64_t m_seen = 0; ///< the number of what fires next
};

} // namespace crowd::widgets
