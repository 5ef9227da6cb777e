// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/rules/triggers/TriggerScope.h"
#include "model/rules/triggers/ClipEnded.h"

namespace crowd::behavior {

/// Nothing happens to find it by: see fireForEndedClips in ActionRunner.h.
inline void evaluate(const TriggerScope& /*scope*/, const model::triggers::ClipEnded& /*trigger*/)
{
}

} // namespace crowd::behavior
