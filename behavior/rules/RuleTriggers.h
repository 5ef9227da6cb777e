// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/RuleState.h"

/// What rules wait for. The run time of each kind of trigger is a header in
/// behavior/rules/triggers, called as its data in model/rules/triggers; the list there is the list
/// here.
namespace crowd::behavior {

/// Fires the rules whose triggers have occurred in this step, in the order of the rules.
void evaluateTriggers(const RuleScope& scope);

} // namespace crowd::behavior
