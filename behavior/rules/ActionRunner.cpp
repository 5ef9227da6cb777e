// SPDX-License-Identifier: MIT
#include "behavior/rules/ActionRunner.h"

#include <algorithm>
#include <utility>

#include "behavior/rules/AllActions.h" // made from the list in model/rules/Actions.h
#include "behavior/rules/ControlFlow.h"
#include "behavior/rules/Errands.h"
#include "behavior/rules/RuleFiring.h"

namespace crowd::behavior {

namespace {

constexpr int kMaxActionsAtOnce = 1024;

/// The line that the agent is at. False: no more in this step.
bool runLine(const ActionScope& scope)
{
    AgentRuleState& self = scope.self();
    const std::uint32_t rule = self.rule;
    const model::Actions& actions = scope.actions();
    if (self.line >= actions.size()) {
        scope.state.agents.setRule(scope.agent, kNoRule);
        fireNextQueued(scope, scope.agent);
        return true;
    }
    const ActionStatus status = runAction(scope, actions[self.line]);
    if (status == ActionStatus::Done && self.rule == rule) {
        self.line = lineAfter(self, actions, self.line);
        self.progress = {};
    }
    return status != ActionStatus::Running;
}

} // namespace

ActionStatus runAction(const ActionScope& scope, const model::Action& action)
{
    return std::visit([&scope](const auto& each) { return run(scope, each); }, action.data);
}

void runAgent(const RuleScope& scope, std::uint32_t agent)
{
    RuleState& state = scope.state;
    const AgentRuleState& self = state.agents[agent];
    for (int count = 0; self.rule != kNoRule; ++count) {
        if (count > 0 && state.budget.actions == 0) {
            reportOverload(state, self.rule);
            return; // in the next step
        }
        state.budget.actions -= std::min<std::size_t>(1, state.budget.actions);
        if (count > kMaxActionsAtOnce) {
            state.problems.add(
                problemOf(state, self.rule,
                          QT_TRANSLATE_NOOP(
                              "Messages",
                              "Rule \"%1\" repeats without any time passing: let it wait or play a "
                              "clip. It was ended.")));
            state.agents.setRule(agent, kNoRule);
            return;
        }
        if (!runLine({scope, agent})) {
            return;
        }
    }
}

void runAgents(const RuleScope& scope)
{
    RuleState& state = scope.state;
    const auto all = static_cast<std::uint32_t>(state.agents.size());
    const std::uint32_t first = state.firstToRun < all ? state.firstToRun : 0;
    state.firstToRun = 0;
    for (const auto& [begin, end] : {std::pair(first, all), std::pair(0U, first)}) {
        for (std::uint32_t agent = state.agents.nextBusy(begin); agent < end;
             agent = state.agents.nextBusy(agent + 1)) {
            if (state.budget.actions == 0) {
                state.firstToRun = agent;
                reportOverload(state, state.agents[agent].rule);
                return;
            }
            runAgent(scope, agent);
        }
    }
}

void runArrived(const RuleScope& scope)
{
    for (const std::uint32_t agent : scope.state.travellers) {
        const AgentRuleState& self = scope.state.agents[agent];
        if (self.progress.isTravelling && self.rule != kNoRule && hasErrandEnded(scope, agent)) {
            runAgent(scope, agent);
        }
    }
}

void fireForEndedClips(const RuleScope& scope)
{
    RuleState& state = scope.state;
    for (std::size_t i = 0; i < state.endedClips.size(); ++i) {
        const EndedClip clip = state.endedClips[i];
        const bool wasFree = state.agents[clip.agent].rule == kNoRule;
        for (std::uint32_t rule = 0; rule < state.rules.size(); ++rule) {
            if (state.rules[rule].data.trigger.is<model::triggers::ClipEnded>() &&
                rule != clip.rule &&
                (state.rules[rule].reachesGone || !scope.host.isGone(clip.agent))) {
                fireOrQueue(scope, rule, clip.agent, clip.context);
            }
        }
        if (wasFree && state.agents[clip.agent].rule != kNoRule) {
            runAgent(scope, clip.agent);
        }
    }
}

} // namespace crowd::behavior
