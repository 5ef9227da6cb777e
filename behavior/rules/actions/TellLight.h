// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/TellLight.h"

namespace crowd::behavior {

inline ActionStatus run(const ActionScope& scope, const model::actions::TellLight& action)
{
    if (!scope.host.tellLight(action)) {
        scope.report(QT_TRANSLATE_NOOP("Messages",
                                       "Rule \"%1\": the light is not there. Choose another one."));
    }
    return ActionStatus::Done;
}

} // namespace crowd::behavior
