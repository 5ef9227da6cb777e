// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/PlayClip.h"

namespace crowd::behavior {

/// Over where he has no such clip.
inline ActionStatus run(const ActionScope& scope, const model::actions::PlayClip& action)
{
    ActionProgress& progress = scope.progress();
    if (progress.isStarted) {
        if (scope.now() < progress.until) {
            return ActionStatus::Running;
        }
        scope.host.endClip(scope.agent);
        scope.state.endedClips.push_back({scope.agent, scope.self().rule, scope.self().context});
        return ActionStatus::Done;
    }
    const std::string clip = drawClip(scope, action.clips);
    const float seconds =
        clip.empty() ? -1.0F : scope.host.play(scope.agent, clip, action.isLooped);
    progress.until = action.isLooped ? endAfter(scope, action.seconds)
                                     : scope.now() + static_cast<double>(seconds);
    progress.isStarted = true;
    return seconds < 0.0F ? ActionStatus::Done : ActionStatus::Running;
}

} // namespace crowd::behavior
