// SPDX-License-Identifier: MIT
#pragma once

#include <string>

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
    const float speed = scope.host.speed(scope.agent);
    if (isHere || scope.host.isGone(scope.agent) || isAtGoal(scope, 0.0F)) {
        holdPlace(scope.state, scope.agent, 0);
        scope.host.leave(scope.agent);
    } else if (isAtGoal(scope, speed * speed / (2.0F * kUsualBraking))) {
        // Who runs begins to come to rest before he is there: on, up to its middle.
        sendTo(scope, scope.state.places.find(scope.self().errand.goal)->position, 0.0F);
        return ActionStatus::Running;
    } else if (scope.progress().isTravelling) {
        const std::string& name = scope.state.places.find(scope.self().errand.goal)->name;
        scope.report(QT_TRANSLATE_NOOP("Messages",
                                       "Rule \"%1\" lets characters leave at \"%2\", but some do "
                                       "not get there: they stay. Move it, or choose another one."),
                     name);
    }
    return ActionStatus::Done;
}

} // namespace crowd::behavior
