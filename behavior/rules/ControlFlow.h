// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "behavior/rules/AgentRuleState.h"
#include "model/rules/RuleSequence.h"

/// In which order the lines of a rule run: those that repeat, and what comes after alternatives.
namespace crowd::behavior {

/// Begins what belongs to the Repeat at that line, which is the one that the agent is at.
void enterLoop(AgentRuleState& agent, const model::Actions& actions, std::uint32_t times);
/// Line to go on with after one that is over, with all that belongs to it; counts repetitions.
[[nodiscard]] std::uint32_t lineAfter(AgentRuleState& agent, const model::Actions& actions,
                                      std::size_t line);

} // namespace crowd::behavior
