// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/FollowPath.h"

namespace crowd::behavior {

inline ActionStatus run(const ActionScope& scope, const model::actions::FollowPath& action)
{
    if (scope.host.follow(scope.agent, action.path)) {
        holdPlace(scope.state, scope.agent, 0);
    } else {
        scope.report(QT_TRANSLATE_NOOP("Messages", "Rule \"%1\" lets characters follow a path that "
                                                   "is not there any more. Choose another one."));
    }
    return ActionStatus::Done;
}

} // namespace crowd::behavior
