// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <QtCore/QObject>

#include "model/rules/RuleSets.h"
#include "widgets/state/EditorState.h"

class QAction;
class QKeySequence;
class QMenu;
class QWidget;

namespace crowd::widgets {

/// What can be done to the rules of the scene, by button, menu and key, and which of them is the
/// chosen one. Every change is one undo step; nothing changes while an edit is open. The state and
/// the list outlive it. Main thread only.
class RuleCommands : public QObject
{
    Q_OBJECT

public:
    using Change = std::function<void(model::Rule&)>;

    /// The keys are those of the list.
    RuleCommands(EditorState& state, QWidget& list, QObject* parent);

    [[nodiscard]] model::RuleId currentId() const { return m_current; }
    /// 0: none.
    void setCurrentId(model::RuleId id) { m_current = id; }
    /// Null where none is chosen, or it is gone.
    [[nodiscard]] const model::Rule* current() const;
    /// Changes the chosen rule.
    void change(const Change& apply);
    /// The first is the most important. Nothing where one of the scene's rules is missing.
    void reorder(std::span<const model::RuleId> order);

    [[nodiscard]] QWidget* makeButtons(QWidget* parent);
    void fill(QMenu& menu) const;
    /// As suits the chosen rule.
    void enable();

private:
    QAction* makeAction(const char* name, const QString& text, const QKeySequence& keys,
                        void (RuleCommands::*run)());
    void setRules(std::vector<model::Rule> rules, const QString& undoText);
    [[nodiscard]] QString freeRuleName() const;
    void addRule();
    void addSet(model::RuleSet set);
    void duplicateRule();
    void removeRule();
    void switchRule();
    void moveRule(std::ptrdiff_t by);
    void moveUp();
    void moveDown();
    void tryRule();

    EditorState& m_state;
    QWidget& m_list;
    model::RuleId m_current = 0;
    QAction* m_duplicate;
    QAction* m_remove;
    QAction* m_switch;
    QAction* m_moveUp;
    QAction* m_moveDown;
    QAction* m_try;
};

} // namespace crowd::widgets
