// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtCore/QTimer>

#include "model/rules/RuleSets.h"
#include "widgets/docks/DockBase.h"
#include "widgets/docks/RuleLog.h"
#include "widgets/state/EditorState.h"

class QAction;
class QCheckBox;
class QLabel;
class QListWidget;
class QPlainTextEdit;
class QVBoxLayout;

namespace crowd::widgets {

/// The rules of the scene as sentences, the first ones the most important; the chosen one is built
/// from menus below. Counts how often each fires while it plays and keeps a log. Every change is
/// one undo step.
class RulesDock : public DockBase
{
    Q_OBJECT

public:
    RulesDock(EditorState& state, QWidget* parent);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    using Change = std::function<void(model::Rule&)>;

    void buildContent();
    void setUpList();
    void addNotes(QVBoxLayout& layout);
    void connectTimers();
    void connectState();
    void connectList();
    void makeActions();
    QAction* makeAction(const char* name, const char* icon, const QString& text,
                        const QKeySequence& keys, void (RulesDock::*run)());
    QWidget* makeButtons(QWidget* parent);
    void enableActions();
    void showMenu(const QPoint& position);
    void rebuildList();
    void fitList();
    void rebuildEditor();
    [[nodiscard]] qsizetype focusedField() const;
    void refreshCounts();
    [[nodiscard]] QString problemOf(const model::Rule& rule) const;
    void showProblems();
    void takeOrder();
    void setRules(std::vector<model::Rule> rules, const QString& undoText);
    void change(const Change& apply);
    void addRule();
    void addSet(model::RuleSet set);
    void duplicateRule();
    void removeRule();
    void switchRule();
    void moveRule(std::ptrdiff_t by);
    void moveUp();
    void moveDown();
    void tryRule();
    void showLog();
    void forgetLog();
    [[nodiscard]] const model::Rule* current() const;

    EditorState& m_state;
    QTimer m_rebuild;
    QTimer m_fit;
    QTimer m_counting;
    model::RuleId m_current = 0;
    bool m_isFilling = false;
    // Children of this widget.
    QListWidget* m_list;
    QLabel* m_note;
    QWidget* m_editorArea;
    QWidget* m_editor = nullptr;
    QLabel* m_problem;
    QCheckBox* m_onlySelected;
    QPlainTextEdit* m_log;
    RuleLog m_fired;
    // What can be done to the chosen rule, by button, menu and key.
    QAction* m_duplicate = nullptr;
    QAction* m_remove = nullptr;
    QAction* m_switch = nullptr;
    QAction* m_moveUp = nullptr;
    QAction* m_moveDown = nullptr;
    QAction* m_try = nullptr;
};

} // namespace crowd::widgets
