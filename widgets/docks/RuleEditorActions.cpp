// SPDX-License-Identifier: MIT
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QToolButton>

#include "model/rules/RuleSequence.h"
#include "widgets/docks/RuleEditor.h"
#include "widgets/docks/RuleFields.h"

/// The order in which a rule lets people do things, and what belongs to what.
namespace crowd::widgets {

using model::Rule;

QString RuleEditor::wordBefore(std::size_t index) const
{
    if (m_rule.actions[index].is<model::actions::OneOf>()) {
        return model::alternativesOf(m_rule.actions, index).front() == index ? tr("either")
                                                                             : tr("or");
    }
    const bool isFirst =
        index == 0 || model::parentOf(m_rule.actions, index) == index - 1; // of all, or in it
    return isFirst ? tr("do") : tr("then");
}

void RuleEditor::addMoveButtons(QHBoxLayout* row, std::size_t index)
{
    const auto addMove = [&](Qt::ArrowType arrow, const QString& tip,
                             void (*shift)(model::Actions&, std::size_t)) {
        model::Actions moved = m_rule.actions;
        shift(moved, index);
        auto* button = new QToolButton(this);
        button->setArrowType(arrow);
        button->setAutoRaise(true);
        button->setFixedWidth(kSmallButton);
        button->setToolTip(tip);
        button->setEnabled(moved != m_rule.actions);
        row->addWidget(button);
        connect(button, &QToolButton::clicked, this,
                [this, index, shift] { m_apply([&](Rule& each) { shift(each.actions, index); }); });
    };
    addMove(Qt::UpArrow, tr("Earlier, or into or out of what repeats"), &model::moveUp);
    addMove(Qt::DownArrow, tr("Later, or into or out of what repeats"), &model::moveDown);
}

/// More of what repeats, or is one of several.
void RuleEditor::addBlockButtons(QHBoxLayout* row, std::size_t index)
{
    addTextButton(
        row, "addInside", tr("+ in it"), tr("Adds something to do in it"),
        [index](Rule& each) { model::addInside(each.actions, index, model::actions::Wait()); });
    if (m_rule.actions[index].is<model::actions::OneOf>()) {
        addTextButton(row, "addAlternative", tr("+ or…"), tr("Adds another one to choose among"),
                      [index](Rule& each) { model::addAlternative(each.actions, index); });
    }
}

} // namespace crowd::widgets
