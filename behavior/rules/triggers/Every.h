// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "behavior/rules/triggers/TriggerScope.h"
#include "model/base/Random.h"
#include "model/rules/triggers/Every.h"

namespace crowd::behavior {

/// True: a period of his is over. The first one begins somewhere in it, so that not all come at
/// once.
[[nodiscard]] inline bool endsPeriod(const TriggerScope& scope, std::uint32_t agent,
                                     const model::triggers::Every& trigger)
{
    const double now = scope.state.clock.seconds;
    const ActiveRule& rule = scope.state.rules[scope.rule];
    double& due = scope.state.rules[scope.rule].due[agent];
    const double period = std::max(1.0 / 30.0, static_cast<double>(trigger.seconds));
    const std::uint64_t key = model::hashKeys(scope.state.seed, scope.host.id(agent), rule.data.id,
                                              rule.agents[agent].count, 51);
    if (due < 0.0) {
        due = now + period * model::unitDouble(key);
        return false;
    }
    due = now + period * (1.0 + static_cast<double>(trigger.jitter) *
                                    (2.0 * model::unitDouble(key) - 1.0));
    return true;
}

inline void evaluate(const TriggerScope& scope, const model::triggers::Every& trigger)
{
    const std::vector<double>& due = scope.state.rules[scope.rule].due;
    for (std::uint32_t agent = 0; agent < due.size(); ++agent) {
        if (due[agent] <= scope.state.clock.seconds && scope.isEvaluatedFor(agent) &&
            endsPeriod(scope, agent, trigger)) {
            fire(scope, scope.rule, agent, {});
        }
    }
}

} // namespace crowd::behavior
