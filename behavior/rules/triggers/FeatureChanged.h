// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/triggers/TriggerScope.h"
#include "model/rules/triggers/FeatureChanged.h"

namespace crowd::behavior {

inline void evaluate(const TriggerScope& scope, const model::triggers::FeatureChanged& trigger)
{
    for (const ChangedFeature& each : scope.state.changedFeatures) {
        const bool isMeant = trigger.feature == 0 || trigger.feature == each.feature;
        if (isMeant && scope.isEvaluatedFor(each.agent)) {
            fire(scope, scope.rule, each.agent, {});
        }
    }
}

} // namespace crowd::behavior
