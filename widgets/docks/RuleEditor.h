// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtWidgets/QWidget>

#include "model/scene/Scene.h"

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
    void addTrigger(QVBoxLayout* layout);
    void addTriggerFields(QHBoxLayout* row);
    void addConditions(QVBoxLayout* layout);
    void addCondition(QVBoxLayout* layout, std::size_t index);
    void addConditionFields(QHBoxLayout* row, std::size_t index);
    void addNegation(QHBoxLayout* row, std::size_t index);
    void addConditionPlace(QHBoxLayout* row, std::size_t index);
    void addSubject(QHBoxLayout* row, std::size_t index);
    void addActions(QVBoxLayout* layout);
    void addAction(QVBoxLayout* layout, std::size_t index);
    [[nodiscard]] QString wordBefore(std::size_t index) const;
    void addBlockFields(QVBoxLayout* layout, std::size_t index);
    void addActionFields(QVBoxLayout* layout, std::size_t index);
    void addLeaveFields(QVBoxLayout* layout, std::size_t index);
    void addSendFields(QVBoxLayout* layout, std::size_t index);
    void addGoFields(QVBoxLayout* layout, std::size_t index);
    void addPropertyFields(QVBoxLayout* layout, std::size_t index);
    void addAimFields(QVBoxLayout* layout, std::size_t index, bool canBePlace);
    void addMore(QVBoxLayout* layout);
    void addMeeting(QVBoxLayout* layout);
    void addTemplate(QHBoxLayout* row, std::size_t index);
    void addComparison(QHBoxLayout* row, std::size_t index, const QString& suffix);
    void setTrigger(const std::function<void(model::Trigger&)>& change);
    void setCondition(std::size_t index, const std::function<void(model::Condition&)>& change);
    void setAction(std::size_t index, const std::function<void(model::Action&)>& change);
    /// A number of an action; at 0 it says `zero` where that is given.
    void addNumber(QHBoxLayout* row, std::size_t index, float model::Action::*member, double low,
                   double high, const QString& suffix, const QString& zero = {});

    const model::Scene& m_scene;
    const model::Rule m_rule;
    std::function<void(const Change&)> m_apply;
    int m_depth = 0; ///< of the line that is being built
};

} // namespace crowd::widgets
