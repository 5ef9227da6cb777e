// SPDX-License-Identifier: MIT
#include "widgets/state/ShownTake.h"

#include <QtCore/QCoreApplication>

#include "widgets/state/EditorState.h"

namespace crowd::widgets {

namespace {

struct TakeText
{
    Q_DECLARE_TR_FUNCTIONS(ShownTake)
};

} // namespace

bool saysThatTakeIsShown(EditorState& state)
{
    const model::Take* shown = model::findTake(state.scene().takes, state.session().take());
    if (shown == nullptr) {
        return false;
    }
    state.showStatus(
        TakeText::tr("The take \"%1\" is shown, and people move as they did in it. To tell them "
                     "something, take it from here (menu Play), or show the scene as it plays "
                     "(panel Takes).")
            .arg(QString::fromStdString(shown->name)));
    return true;
}

} // namespace crowd::widgets
