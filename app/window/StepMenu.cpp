// SPDX-License-Identifier: MIT
#include "app/window/StepMenu.h"

#include <QtCore/QCoreApplication>
#include <QtWidgets/QMenu>

#include "app/window/ChoiceMenu.h"
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
    const auto outcome =
        state.document().edit(StepMenuText::tr("Change the length of a step"),
                              [steps](model::SceneEdit& edit) { edit.setStepsPerSecond(steps); });
    if (outcome == model::EditOutcome::Committed && state.session().isRunning()) {
        state.showStatus(StepMenuText::tr("Steps of 1/%1 s from the next Play on.").arg(steps));
    }
}

} // namespace

void fillStepMenu(QMenu& menu, widgets::EditorState& state)
{
    ChoiceMenu choices(menu);
    for (const std::uint32_t steps : model::kStepRates) {
        choices.add(
            {.name = QStringLiteral("steps%1").arg(steps),
             .text = steps == model::kStepRates.front()
                         ? StepMenuText::tr("1/%1 s, as Usual").arg(steps)
                         : StepMenuText::tr("1/%1 s, Finer").arg(steps),
             .choose = [&state, steps] { chooseSteps(state, steps); },
             .isChosen = [&state, steps] { return state.scene().stepsPerSecond == steps; }});
    }
}

} // namespace crowd::app
