// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "behavior/rules/EventQueue.h"
#include "behavior/rules/RuleState.h"

/// Whom rules mean by those who are related to somebody. `relation`: the id of a kind, 0 any.
namespace crowd::behavior {

/// Those related to him, whichever way, who are here; ascending agents, each once.
[[nodiscard]] std::vector<std::uint32_t> relatedAgents(const RuleState& state, std::uint32_t agent,
                                                       std::uint32_t relation);
/// The nearest of those who have not left; kNoAgent: there is none.
[[nodiscard]] std::uint32_t nearestRelated(const RuleScope& scope, std::uint32_t agent,
                                           std::uint32_t relation);
[[nodiscard]] bool areRelated(const RuleState& state, std::uint32_t agent, std::uint32_t other,
                              std::uint32_t relation);

/// He hears it. False: he has heard that call of it before, by whatever way.
[[nodiscard]] bool hearsFirst(RuleState& state, std::uint32_t agent, const QueuedEvent& event);
/// What he has heard goes on to those to whom a kind of relation passes it, a little later. A call
/// comes to nobody twice in that way.
void passOn(const RuleScope& scope, std::uint32_t agent, const QueuedEvent& event);

} // namespace crowd::behavior
