// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <functional>

#include <QtCore/QTimer>

#include "model/scene/RuleSets.h"
#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QLabel;
class QListWidget;
class QCheckBox;
class QPlainTextEdit;

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

    QWidget* makeButtons(QWidget* parent);
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
    void tryRule();
    void showLog();
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
    struct LogLine
    {
        double seconds = 0.0;
        model::RuleId rule = 0;
        model::IndividualId who = 0;
    };
    std::deque<LogLine> m_lines;
};

} // namespace crowd::widgets
