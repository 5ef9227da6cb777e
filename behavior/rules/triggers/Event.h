// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/triggers/TriggerScope.h"
#include "model/rules/triggers/Event.h"

namespace crowd::behavior {

/// Nothing happens to find it by: see EventDelivery.h.
inline void evaluate(const TriggerScope& /*scope*/, const model::triggers::Event& /*trigger*/) {}

} // namespace crowd::behavior
