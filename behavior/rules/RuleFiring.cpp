// SPDX-License-Identifier: MIT
#include "behavior/rules/RuleFiring.h"

#include <algorithm>

#include "behavior/rules/RuleConditions.h"

namespace crowd::behavior {

namespace {

constexpr double kEchoSeconds = 0.2;
constexpr std::uint32_t kMaxEchoes = 30;
constexpr std::size_t kMaxQueue = 8;

/// Those of the same rule that wait already count too.
bool isQueueable(const RuleState& state, std::uint32_t index, std::uint32_t agent)
{
    const model::Rule& rule = state.rules[index].data;
    const std::vector<QueuedRule>& queue = state.agents[agent].queue;
    const auto waiting = std::ranges::count(queue, rule.id, &QueuedRule::rule);
    const std::uint32_t count = state.rules[index].agents[agent].count;
    return queue.size() < kMaxQueue && (rule.cooldownSeconds <= 0.0F || waiting == 0) &&
           (rule.limit == 0 || count + static_cast<std::size_t>(waiting) < rule.limit);
}

/// A call that is still being passed on does not break off what a later one began.
bool isOutdated(const AgentRuleState& self, const TriggerContext& context)
{
    return context.calledAt >= 0.0 && context.calledAt < self.context.calledAt;
}

bool mayInterrupt(const RuleState& state, std::uint32_t other, const AgentRuleState& self,
                  const TriggerContext& context)
{
    switch (state.rules[self.rule].data.yields) {
    case model::RuleYield::FurtherUp:
        return other <= self.rule;
    case model::RuleYield::Anybody:
        return !isOutdated(self, context);
    case model::RuleYield::Others:
        return other < self.rule;
    case model::RuleYield::Nobody:
        break;
    }
    return false;
}

/// Events that people send each other round and round, as fast as steps follow each other.
void noticeEcho(RuleState& state, std::uint32_t rule, RuleAgentState& known,
                const TriggerContext& context)
{
    const bool isEcho =
        context.sender != 0 && state.clock.seconds - known.lastFired <= kEchoSeconds;
    known.echoes = isEcho ? known.echoes + 1 : 0;
    if (known.echoes == kMaxEchoes) {
        state.problems.add(
            problemOf(state, rule,
                      QT_TRANSLATE_NOOP("Messages", "Rule \"%1\" fires over and over for the same "
                                                    "characters: events go round in a circle. "
                                                    "Give it a pause, or say how often at most.")));
    }
}

void begin(const RuleScope& scope, std::uint32_t rule, std::uint32_t agent,
           const TriggerContext& context)
{
    RuleState& state = scope.state;
    RuleAgentState& known = state.rules[rule].agents[agent];
    noticeEcho(state, rule, known, context);
    known.lastFired = state.clock.seconds;
    ++known.count;
    AgentRuleState& self = state.agents[agent];
    ++self.firings;
    state.agents.setRule(agent, rule);
    self.line = 0;
    self.branches = 0;
    self.loops.clear();
    self.progress = {};
    self.context = context;
    if (context.calledAt < 0.0) {
        self.context.calledAt = state.clock.seconds;
    }
    state.log.add({state.clock.seconds, state.rules[rule].data.id, scope.host.id(agent)}, agent);
}

} // namespace

bool isDue(const RuleState& state, std::uint32_t rule, std::uint32_t agent)
{
    const model::Rule& data = state.rules[rule].data;
    const RuleAgentState& known = state.rules[rule].agents[agent];
    return state.clock.seconds >= known.lastFired + static_cast<double>(data.cooldownSeconds) &&
           (data.limit == 0 || known.count < data.limit);
}

bool fire(const RuleScope& scope, std::uint32_t rule, std::uint32_t agent,
          const TriggerContext& context)
{
    RuleState& state = scope.state;
    const model::Rule& data = state.rules[rule].data;
    if (!isDue(state, rule, agent) || !conditionsHold(scope, data, agent, context)) {
        return false;
    }
    AgentRuleState& self = state.agents[agent];
    if (self.rule != kNoRule) {
        if (data.meeting == model::RuleMeeting::Queue && isQueueable(state, rule, agent)) {
            self.queue.push_back({data.id, context});
            return true;
        }
        if (data.meeting != model::RuleMeeting::Interrupt ||
            !mayInterrupt(state, rule, self, context)) {
            return false;
        }
        scope.host.endClip(agent);
    }
    begin(scope, rule, agent, context);
    return true;
}

void fireOrQueue(const RuleScope& scope, std::uint32_t rule, std::uint32_t agent,
                 const TriggerContext& context)
{
    RuleState& state = scope.state;
    const model::Rule& data = state.rules[rule].data;
    AgentRuleState& self = state.agents[agent];
    if (self.rule == kNoRule) {
        fire(scope, rule, agent, context);
    } else if (data.meeting != model::RuleMeeting::Ignore && isDue(state, rule, agent) &&
               isQueueable(state, rule, agent) && conditionsHold(scope, data, agent, context)) {
        self.queue.push_back({data.id, context});
    }
}

void fireNextQueued(const RuleScope& scope, std::uint32_t agent)
{
    RuleState& state = scope.state;
    AgentRuleState& self = state.agents[agent];
    while (self.rule == kNoRule && !self.queue.empty()) {
        const QueuedRule next = self.queue.front();
        self.queue.erase(self.queue.begin());
        const auto found = std::ranges::find(state.rules, next.rule,
                                             [](const ActiveRule& each) { return each.data.id; });
        const auto rule = static_cast<std::uint32_t>(found - state.rules.begin());
        if (found != state.rules.end() && isDue(state, rule, agent)) {
            begin(scope, rule, agent, next.context);
        }
    }
}

} // namespace crowd::behavior
