// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "behavior/rules/triggers/TriggerScope.h"
#include "model/rules/triggers/SpeedLimit.h"

namespace crowd::behavior {

/// A speed became higher or lower than the limit, by a tenth of it; what it is at first does not
/// count.
inline void evaluate(const TriggerScope& scope, const model::triggers::SpeedLimit& trigger)
{
    constexpr float kMargin = 0.1F; // share of the limit
    fireForAgents(scope, [&](std::uint32_t agent) {
        RuleAgentState& known = scope.of(agent);
        const float speed = scope.host.speed(agent);
        const float margin = trigger.isAbove != known.wasThere ? 1.0F + kMargin : 1.0F - kMargin;
        const float limit = trigger.metresPerSecond * (known.isSeen ? margin : 1.0F);
        const bool isThere = trigger.isAbove ? speed > limit : speed < limit;
        const bool wasThere = std::exchange(known.wasThere, isThere);
        return std::exchange(known.isSeen, true) && isThere && !wasThere;
    });
}

} // namespace crowd::behavior
