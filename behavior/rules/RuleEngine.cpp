// SPDX-License-Identifier: MIT
#include "behavior/rules/RuleEngine.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "behavior/motion/TravelEvents.h"
#include "behavior/rules/ActionRunner.h"
#include "behavior/rules/EventDelivery.h"
#include "behavior/rules/RuleTriggers.h"
#include "model/rules/RuleFlaws.h"

namespace crowd::behavior {

namespace {

// What rules may do in a step, beside so much for everybody.
constexpr std::size_t kActionsInStep = 100'000;
constexpr std::size_t kHeardInStep = 50'000;
constexpr std::size_t kAskedInStep = 10'000'000;
constexpr std::size_t kActionsEach = 4;
constexpr std::size_t kHeardEach = 2;

bool bringsBack(const model::Rule& rule)
{
    return std::ranges::any_of(rule.actions, [](const model::Action& action) {
        return action.is<model::actions::Appear>();
    });
}

/// Where people line up: the places on which a rule lets them move up.
std::vector<PlaceWish> linesOf(const std::vector<ActiveRule>& rules)
{
    std::vector<PlaceWish> lines;
    for (const ActiveRule& rule : rules) {
        for (const model::Action& action : rule.data.actions) {
            const auto* go = action.as<model::actions::GoToPlace>();
            if (go != nullptr && go->choice == model::PlaceChoice::Ahead) {
                lines.push_back({go->choice, go->place, go->path});
            }
        }
    }
    return lines;
}

/// Those that can run. What the former ones know of agents moves over; `now` becomes the index of
/// each former one whose actions are as they were.
std::vector<ActiveRule> activeRules(const model::Scene& scene, std::vector<ActiveRule>& former,
                                    std::vector<std::uint32_t>& now)
{
    std::vector<ActiveRule> rules;
    now.assign(former.size(), kNoRule);
    for (const model::Rule& rule : scene.rules) {
        if (!rule.isEnabled || model::gapOf(rule)) {
            continue;
        }
        ActiveRule& active = rules.emplace_back(ActiveRule{rule, bringsBack(rule)});
        const auto known =
            std::ranges::find(former, rule.id, [](const ActiveRule& each) { return each.data.id; });
        if (known != former.end()) {
            active.agents = std::move(known->agents);
            active.due = std::move(known->due);
            // One with other actions begins anew at its next occasion.
            if (known->data.actions == rule.actions) {
                now[static_cast<std::size_t>(known - former.begin())] =
                    static_cast<std::uint32_t>(rules.size() - 1);
            }
        }
    }
    return rules;
}

void noteTravelEvents(const RuleScope& scope)
{
    RuleState& state = scope.state;
    const std::span<const std::uint8_t> events = scope.host.travelEvents();
    state.travellers.clear();
    for (std::uint32_t agent = 0; agent < events.size(); ++agent) {
        if (events[agent] != 0) {
            state.travellers.push_back(agent);
            ErrandState& errand = state.agents[agent].errand; // before he sets out anew
            errand.arrived = (events[agent] & kEndedErrand) != 0 ? errand.goal : 0;
        }
    }
}

} // namespace

void RuleEngine::setRules(const model::Scene& scene, bool areNumbersKept)
{
    std::vector<std::uint32_t> now;
    m_state.rules = activeRules(scene, m_state.rules, now);
    for (ActiveRule& rule : m_state.rules) {
        rule.agents.resize(m_state.agents.size());
        rule.due.resize(m_state.agents.size(), kDueUnknown);
    }
    for (std::uint32_t agent = 0; agent < m_state.agents.size(); ++agent) {
        const std::uint32_t former = m_state.agents[agent].rule;
        m_state.agents.setRule(agent, former == kNoRule ? kNoRule : now[former]);
    }
    m_state.places.setPlaces(scene.places, scene.paths);
    m_state.places.setLines(linesOf(m_state.rules));
    m_state.seed = scene.seed;
    m_state.relations = scene.relations;
    m_state.relationKinds = scene.relationKinds;
    m_state.numbers.setNumbers(scene.numbers, scene.seed, areNumbersKept, m_state.agents.ids());
    m_state.problems.clear();
    for (const model::RuleFlaw& flaw : model::flawsOf(scene)) {
        m_state.problems.add({model::englishOf(flaw, scene), flaw.rule});
    }
}

void RuleEngine::setPeople(const model::Population& people, std::span<const std::uint32_t> keep)
{
    m_state.agents.setPeople(people.ids(), people.column(model::columns::tags), keep);
    m_state.numbers.setPeople(people.ids(), keep);
    m_state.log.setPeople(keep);
    m_recalled.clear(); // of agents as they were
    m_dueFeatures.clear();
    m_changedFeatures.clear();
    for (ActiveRule& rule : m_state.rules) {
        rearrange(rule.agents, keep);
        rearrange(rule.due, keep, kDueUnknown);
    }
}

void RuleEngine::send(const std::string& event, float payload, std::uint32_t agent,
                      const glm::vec3& origin)
{
    const std::span<const model::IndividualId> ids = m_state.agents.ids();
    if (agent < ids.size() && std::isfinite(payload)) {
        const double now = m_state.clock.seconds;
        m_state.events.post({now, event, payload, ids[agent], origin, 0, now});
    }
}

void RuleEngine::beginStep(std::uint64_t step)
{
    m_state.clock = {step, static_cast<double>(step) / m_stepsPerSecond};
    m_state.places.forget();
    m_state.people.clear();
    m_state.endedClips.clear();
    m_state.recalled = std::exchange(m_recalled, {});
    m_state.changedFeatures = std::exchange(m_dueFeatures, std::exchange(m_changedFeatures, {}));
    m_state.budget = {kActionsInStep + kActionsEach * m_state.agents.size(),
                      kHeardInStep + kHeardEach * m_state.agents.size(), kAskedInStep};
    m_state.problems.beginStep();
    m_state.log.update(m_state.clock.seconds);
}

void RuleEngine::step(RuleHost& host, std::uint64_t step)
{
    beginStep(step);
    const RuleScope scope{m_state, host};
    noteTravelEvents(scope);
    deliverEvents(scope);
    runArrived(scope);
    evaluateTriggers(scope);
    runAgents(scope);
    fireForEndedClips(scope);
}

} // namespace crowd::behavior
