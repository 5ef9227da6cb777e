// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include "behavior/rules/Aims.h"
#include "behavior/rules/Errands.h"
#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/Flee.h"

namespace crowd::behavior {

/// Straight away from it; anywhere from where it is nowhere.
inline ActionStatus run(const ActionScope& scope, const model::actions::Flee& action)
{
    constexpr float kAllAround = 6.2831853F;
    constexpr float kLeastMetres = 0.05F; // nearer points have no direction
    ActionProgress& progress = scope.progress();
    if (scope.host.isGone(scope.agent)) {
        return ActionStatus::Done;
    }
    if (progress.isTravelling) {
        return hasErrandEnded(scope, scope.agent) ? ActionStatus::Done : ActionStatus::Running;
    }
    progress.isStarted = true;
    progress.isTravelling = true;
    const glm::vec3 at = scope.host.position(scope.agent);
    const std::optional<Aim> from = aimOf(scope, action);
    glm::vec3 away = from ? at - from->point : glm::vec3(0.0F);
    away.y = 0.0F;
    const float length = std::sqrt(away.x * away.x + away.z * away.z);
    const float angle = kAllAround * draw(scope, scope.agent, 81);
    away =
        length > kLeastMetres ? away / length : glm::vec3(std::sin(angle), 0.0F, std::cos(angle));
    sendAway(scope, at + away * action.metres);
    return ActionStatus::Running;
}

} // namespace crowd::behavior
