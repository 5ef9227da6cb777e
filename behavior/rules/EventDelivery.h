// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/RuleState.h"

/// Tells agents of events that have reached them: a WaitForEvent action that waits for one is over,
/// and rules that an event triggers fire.
namespace crowd::behavior {

/// All that are due, in the order in which they were sent, as many as the step has room for.
/// Nothing that is done here sends an event.
void deliverEvents(const RuleScope& scope);
/// An event has reached somebody.
void notify(const RuleScope& scope, std::uint32_t agent, const QueuedEvent& event);

} // namespace crowd::behavior
