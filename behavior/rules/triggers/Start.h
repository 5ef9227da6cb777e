// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "behavior/rules/triggers/TriggerScope.h"
#include "model/rules/triggers/Start.h"

namespace crowd::behavior {

/// Once for everybody who is there.
inline void evaluate(const TriggerScope& scope, const model::triggers::Start& /*trigger*/)
{
    fireForAgents(scope, [&scope](std::uint32_t agent) {
        return !std::exchange(scope.of(agent).wasThere, true);
    });
}

} // namespace crowd::behavior
