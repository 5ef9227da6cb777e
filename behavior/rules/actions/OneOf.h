// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "behavior/rules/ControlFlow.h"
#include "behavior/rules/actions/ActionScope.h"
#include "model/base/Random.h"
#include "model/base/WeightedDraw.h"
#include "model/rules/actions/OneOf.h"

namespace crowd::behavior {

/// Draws one of the alternatives of which this is the first, by weight.
inline ActionStatus run(const ActionScope& scope, const model::actions::OneOf& /*action*/)
{
    AgentRuleState& self = scope.self();
    const model::Actions& actions = scope.actions();
    const std::vector<std::size_t> lines = model::alternativesOf(actions, self.line);
    const float share = draw(scope, scope.agent, model::hashKeys(self.line, 72, self.branches));
    const std::size_t chosen =
        lines[model::weightedIndex(lines, share, [&actions](std::size_t line) {
            return actions[line].as<model::actions::OneOf>()->weight;
        })];
    ++self.branches;
    self.line = model::endOf(actions, chosen) == chosen + 1
                    ? lineAfter(self, actions, lines.back()) // there is nothing in it
                    : static_cast<std::uint32_t>(chosen + 1);
    return ActionStatus::Jumped;
}

} // namespace crowd::behavior
