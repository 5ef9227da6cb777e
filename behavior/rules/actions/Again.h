// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/actions/ActionScope.h"
#include "model/rules/actions/Again.h"

namespace crowd::behavior {

/// The rule runs from its first line.
inline ActionStatus run(const ActionScope& scope, const model::actions::Again& /*action*/)
{
    AgentRuleState& self = scope.self();
    self.loops.clear();
    ++self.branches;
    self.line = 0;
    return ActionStatus::Jumped;
}

} // namespace crowd::behavior
