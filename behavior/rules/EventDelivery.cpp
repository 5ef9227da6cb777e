// SPDX-License-Identifier: MIT
#include "behavior/rules/EventDelivery.h"

#include "behavior/rules/RelatedAgents.h"
#include "behavior/rules/RuleFiring.h"

namespace crowd::behavior {

namespace {

bool isWaitingFor(const RuleState& state, const AgentRuleState& self, const std::string& event)
{
    if (self.rule == kNoRule || !self.progress.isStarted) {
        return false;
    }
    const model::Action& action = state.rules[self.rule].data.actions[self.line];
    const auto* wait = action.as<model::actions::WaitForEvent>();
    return wait != nullptr && wait->event == event;
}

} // namespace

namespace {

/// Those who are related to whoever has heard it.
void notifyRelated(const RuleScope& scope, std::uint32_t agent, const QueuedEvent& event)
{
    RuleState& state = scope.state;
    for (std::uint32_t rule = 0; rule < state.rules.size(); ++rule) {
        const auto* trigger = state.rules[rule].data.trigger.as<model::triggers::RelatedDid>();
        if (trigger == nullptr || trigger->deed != model::RelatedDeed::Hears ||
            trigger->event != event.name) {
            continue;
        }
        const TriggerContext context{event.payload, scope.host.position(agent), true,
                                     state.agents.ids()[agent], event.calledAt};
        for (const std::uint32_t other : relatedAgents(state, agent, trigger->relation)) {
            if (state.rules[rule].reachesGone || !scope.host.isGone(other)) {
                fire(scope, rule, other, context);
            }
        }
    }
}

} // namespace

void deliverEvents(const RuleScope& scope)
{
    RuleState& state = scope.state;
    const double now = state.clock.seconds;
    while (state.events.hasDue(now)) {
        if (state.budget.heard == 0) {
            reportOverload(state, kNoRule);
            return;
        }
        --state.budget.heard;
        const QueuedEvent event = state.events.take();
        const std::uint32_t agent = state.agents.agentNamed(event.receiver);
        if (agent == kNoAgent) {
            continue;
        }
        const bool isFirst = hearsFirst(state, agent, event);
        if (isFirst || event.passes == 0) {
            notify(scope, agent, event);
        }
        if (isFirst) {
            passOn(scope, agent, event);
        }
    }
}

void notify(const RuleScope& scope, std::uint32_t agent, const QueuedEvent& event)
{
    RuleState& state = scope.state;
    const TriggerContext context{event.payload, event.origin, true, event.sender, event.calledAt};
    AgentRuleState& self = state.agents[agent];
    if (isWaitingFor(state, self, event.name)) {
        self.progress.hasHeardEvent = true;
        self.context = context;
    }
    for (std::uint32_t rule = 0; rule < state.rules.size(); ++rule) {
        const auto* trigger = state.rules[rule].data.trigger.as<model::triggers::Event>();
        if (trigger != nullptr && trigger->event == event.name &&
            (state.rules[rule].reachesGone || !scope.host.isGone(agent))) {
            fire(scope, rule, agent, context);
        }
    }
    notifyRelated(scope, agent, event);
}

} // namespace crowd::behavior
