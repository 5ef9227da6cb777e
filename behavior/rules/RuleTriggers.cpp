// SPDX-License-Identifier: MIT
#include "behavior/rules/RuleTriggers.h"

#include "behavior/rules/AllTriggers.h" // made from the list in model/rules/Triggers.h

namespace crowd::behavior {

void evaluateTriggers(const RuleScope& scope)
{
    for (std::uint32_t rule = 0; rule < scope.state.rules.size(); ++rule) {
        const TriggerScope each{scope, rule};
        std::visit([&each](const auto& trigger) { evaluate(each, trigger); },
                   scope.state.rules[rule].data.trigger.data);
    }
}

} // namespace crowd::behavior
