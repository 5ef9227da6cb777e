// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "behavior/rules/RuleState.h"

/// Whom an event reaches that somebody sends.
namespace crowd::behavior {

/// Those among whom they are all; null: everybody. Agents, ascending. Valid until the next call.
[[nodiscard]] const std::vector<std::uint32_t>*
candidatesOf(const RuleScope& scope, std::uint32_t sender, const model::actions::SendEvent& action);
[[nodiscard]] bool reaches(const RuleScope& scope, std::uint32_t sender, std::uint32_t other,
                           const model::actions::SendEvent& action);

} // namespace crowd::behavior
