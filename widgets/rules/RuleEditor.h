// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtWidgets/QWidget>

#include "model/scene/Scene.h"
#include "widgets/rules/RulePartRows.h"

class QHBoxLayout;
class QVBoxLayout;

namespace crowd::widgets {

/// One rule as a sentence of menus and numbers. Shows what it was made with; whoever owns it makes
/// another one when the rule has changed. The scene outlives it.
class RuleEditor : public QWidget
{
    Q_OBJECT

public:
    using Change = std::function<void(model::Rule&)>;
    /// `apply` is called with each change that the artist makes, one undo step each.
    RuleEditor(const model::Scene& scene, const model::Rule& rule,
               std::function<void(const Change&)> apply, QWidget* parent);

    /// Fields of the last one of its kind, which is what was added last; null: there is none.
    [[nodiscard]] QWidget* lastCondition() const { return m_lastCondition; }
    [[nodiscard]] QWidget* lastAction() const { return m_lastAction; }

private:
    /// As far in as the line that is being built.
    QHBoxLayout* rowIn(QVBoxLayout* layout) const;
    /// What belongs to the row above, a little further in.
    QHBoxLayout* indentedRowIn(QVBoxLayout* layout) const;
    /// Indented, with what a number means in front of it.
    [[nodiscard]] QHBoxLayout* labelledRowIn(QVBoxLayout* layout, const QString& label,
                                             const QString& tip = {}) const;
    void addTextButton(QHBoxLayout* row, const char* name, const QString& text, const QString& tip,
                       const Change& change);
    void addKindButton(QHBoxLayout* row, const char* name, const QString& text, const QString& tip,
                       std::span<const model::RuleKind> kinds,
                       void (*add)(model::Rule&, std::size_t kind));
    void addTrigger(QVBoxLayout* layout);
    void addCondition(QVBoxLayout* layout, std::size_t index);
    void addNegation(QHBoxLayout* row, std::size_t index);
    void addAction(QVBoxLayout* layout, std::size_t index);
    void addBlockButtons(QHBoxLayout* row, std::size_t index);
    void addMore(QVBoxLayout* layout);
    void addMeeting(QVBoxLayout* layout);
    /// Rows of a part's fields. `partOf` finds it in a rule, where it may be of another kind by
    /// now.
    template<class Part>
    [[nodiscard]] PartRows rowsFor(QVBoxLayout* layout, std::function<Part&(model::Rule&)> partOf);

    const model::Scene& m_scene;
    const model::Rule m_rule;
    std::function<void(const Change&)> m_apply;
    int m_depth = 0; ///< of the line that is being built
    QWidget* m_lastCondition = nullptr;
    QWidget* m_lastAction = nullptr;
};

} // namespace crowd::widgets
