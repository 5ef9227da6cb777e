// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "behavior/rules/RuleState.h"

/// Whether a rule whose trigger has occurred fires, and what happens to the rule that somebody is
/// busy with: it is interrupted, or the new one waits, or is ignored. Rules by index.
namespace crowd::behavior {

/// Neither its pause nor its limit keeps it from firing.
[[nodiscard]] bool isDue(const RuleState& state, std::uint32_t rule, std::uint32_t agent);
/// Fires or queues it where its conditions hold. False: it does not come to it, now at least.
bool fire(const RuleScope& scope, std::uint32_t rule, std::uint32_t agent,
          const TriggerContext& context);
/// The same for whoever is free; for whoever is busy it is queued where it does not ignore him.
void fireOrQueue(const RuleScope& scope, std::uint32_t rule, std::uint32_t agent,
                 const TriggerContext& context);
/// Begins the next rule that waits for him and still may fire.
void fireNextQueued(const RuleScope& scope, std::uint32_t agent);

} // namespace crowd::behavior
