// SPDX-License-Identifier: MIT
#include "app/window/LookMenu.h"

#include <QtCore/QCoreApplication>
#include <QtWidgets/QMenu>

#include "app/window/ChoiceMenu.h"
#include "render/Looks.h"
#include "widgets/state/EditorState.h"

namespace crowd::app {

void fillLookMenu(QMenu& menu, widgets::EditorState& state)
{
    ChoiceMenu choices(menu);
    for (const render::LookInfo& info : render::kLooks) {
        choices.add(
            {.name = QStringLiteral("look-choice-") + QLatin1String(info.key),
             .text = QCoreApplication::translate("Looks", info.label),
             .tip = QCoreApplication::translate("Looks", info.tip),
             .choose =
                 [&state, look = info.look] {
                     widgets::ViewOptions options = state.viewOptions();
                     options.look = look;
                     state.setViewOptions(options);
                 },
             .isChosen = [&state, look = info.look] { return state.viewOptions().look == look; }});
    }
}

} // namespace crowd::app
