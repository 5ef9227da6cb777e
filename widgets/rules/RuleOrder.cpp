// SPDX-License-Identifier: MIT
#include "widgets/rules/RuleOrder.h"

#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QToolButton>

#include "widgets/rules/RuleEditor.h"
#include "widgets/rules/RuleFields.h"

namespace crowd::widgets {

QString wordBefore(const model::Actions& actions, std::size_t index)
{
    if (actions[index].is<model::actions::OneOf>()) {
        return model::alternativesOf(actions, index).front() == index ? RuleEditor::tr("either")
                                                                      : RuleEditor::tr("or");
    }
    const bool isFirst =
        index == 0 || model::parentOf(actions, index) == index - 1; // of all, or in it
    return isFirst ? RuleEditor::tr("do") : RuleEditor::tr("then");
}

void addMoveButtons(QHBoxLayout& row, QWidget& editor, const model::Actions& actions,
                    std::size_t index, const ApplyToRule& apply)
{
    const auto addMove = [&](Qt::ArrowType arrow, const QString& tip,
                             void (*shift)(model::Actions&, std::size_t)) {
        model::Actions moved = actions;
        shift(moved, index);
        auto* button = new QToolButton(&editor);
        button->setArrowType(arrow);
        button->setAutoRaise(true);
        button->setFixedWidth(kSmallButton);
        button->setToolTip(tip);
        button->setEnabled(moved != actions);
        row.addWidget(button);
        QObject::connect(button, &QToolButton::clicked, &editor, [apply, index, shift] {
            apply([&](model::Rule& each) { shift(each.actions, index); });
        });
    };
    addMove(Qt::UpArrow, RuleEditor::tr("Earlier, or into or out of what repeats"), &model::moveUp);
    addMove(Qt::DownArrow, RuleEditor::tr("Later, or into or out of what repeats"),
            &model::moveDown);
}

} // namespace crowd::widgets
