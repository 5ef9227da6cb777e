// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/Errands.h"
#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/Appear.h"

namespace crowd::behavior {

inline ActionStatus run(const ActionScope& scope, const model::actions::Appear& action)
{
    const model::Place* place = scope.state.places.find(action.place);
    if (place == nullptr) {
        scope.report(QT_TRANSLATE_NOOP(
            "Messages", "Rule \"%1\" lets characters appear at a place that is not there any "
                        "more. Choose another one."));
        return ActionStatus::Done;
    }
    scope.host.appear(scope.agent, pointIn(scope, *place));
    scope.state.people.noteAppeared(scope.agent, scope.host.position(scope.agent));
    return ActionStatus::Done;
}

} // namespace crowd::behavior
