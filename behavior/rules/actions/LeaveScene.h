// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/motion/StrideKernel.h"
#include "behavior/rules/Errands.h"
#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/LeaveScene.h"

namespace crowd::behavior {

/// Where he is, or where he is to go first; who has nowhere to leave at stays.
inline ActionStatus run(const ActionScope& scope, const model::actions::LeaveScene& action)
{
    const bool isHere = action.isHere();
    const PlaceWish wish{action.choice, action.place, action.path, model::PlaceRole::Exit};
    if (!isHere && travel(scope, wish) == ActionStatus::Running) {
        return ActionStatus::Running;
    }
    const model::Place* goal = scope.state.places.find(scope.self().errand.goal);
    const float speed = scope.host.speed(scope.agent);
    if (isHere || scope.host.isGone(scope.agent) || isAtGoal(scope, 0.0F)) {
        holdPlace(scope.state, scope.agent, 0);
        scope.host.leave(scope.agent);
    } else if (goal != nullptr && isAtGoal(scope, speed * speed / (2.0F * kUsualBraking))) {
        // Who runs begins to come to rest before he is there: on, up to its middle.
        sendTo(scope, goal->position, 0.0F);
        return ActionStatus::Running;
    } else if (goal != nullptr && scope.progress().isTravelling) {
        scope.report(QT_TRANSLATE_NOOP("Messages",
                                       "Rule \"%1\" lets characters leave at \"%2\", but some do "
                                       "not get there: they stay. Move it, or choose another one."),
                     goal->name);
    }
    return ActionStatus::Done;
}

} // namespace crowd::behavior
