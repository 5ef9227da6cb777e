// SPDX-License-Identifier: MIT
#include "app/window/StepMenu.h"

#include <QtCore/QCoreApplication>
#include <QtGui/QActionGroup>
#include <QtWidgets/QMenu>

#include "model/document/SceneEdit.h"
#include "widgets/state/EditorState.h"

namespace crowd::app {

namespace {

struct StepMenuText
{
    Q_DECLARE_TR_FUNCTIONS(StepMenu)
};

void chooseSteps(widgets::EditorState& state, std::uint32_t steps)
{
    if (state.document().isEditOpen()) {
        return;
    }
    auto edit = state.document().beginEdit();
    edit->setStepsPerSecond(steps);
    if (edit->commit(StepMenuText::tr("Change the length of a step")) &&
        state.session().isRunning()) {
        state.showStatus(StepMenuText::tr("Steps of 1/%1 s from the next Play on.").arg(steps));
    }
}

} // namespace

void fillStepMenu(QMenu& menu, widgets::EditorState& state)
{
    auto* group = new QActionGroup(&menu);
    for (const std::uint32_t steps : model::kStepRates) {
        QAction* action = menu.addAction(QString());
        action->setObjectName(QStringLiteral("steps%1").arg(steps));
        action->setCheckable(true);
        group->addAction(action);
        QObject::connect(action, &QAction::triggered, &menu,
                         [&state, steps] { chooseSteps(state, steps); });
    }
    QObject::connect(&menu, &QMenu::aboutToShow, &menu, [&menu, &state] {
        std::size_t i = 0;
        for (QAction* action : menu.actions()) {
            const std::uint32_t steps = model::kStepRates.at(i++);
            action->setText(steps == model::kStepRates.front()
                                ? StepMenuText::tr("1/%1 s, as Usual").arg(steps)
                                : StepMenuText::tr("1/%1 s, Finer").arg(steps));
            action->setChecked(state.scene().stepsPerSecond == steps);
        }
    });
}

} // namespace crowd::app
