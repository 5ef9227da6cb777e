// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "behavior/rules/RuleState.h"

/// What rules ask before they fire.
namespace crowd::behavior {

/// Whether a condition is true of an agent, before it is negated. `key` is what its draws are made
/// with.
[[nodiscard]] bool isTrue(const RuleScope& scope, const model::Condition& condition,
                          std::uint64_t key, std::uint32_t agent, const TriggerContext& context);
/// Whether those of a rule let it fire: all of them, or any where that is enough.
[[nodiscard]] bool conditionsHold(const RuleScope& scope, const model::Rule& rule,
                                  std::uint32_t agent, const TriggerContext& context);

} // namespace crowd::behavior
