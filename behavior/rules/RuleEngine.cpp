// SPDX-License-Identifier: MIT
#include "behavior/rules/RuleEngine.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "behavior/session/PathFollower.h"
#include "model/base/Random.h"

namespace crowd::behavior {

namespace {

constexpr std::size_t kMaxEvents = 500'000;
constexpr std::size_t kMaxLog = 4096;
constexpr std::size_t kMaxQueue = 8;
constexpr int kMaxActionsAtOnce = 64;
constexpr std::uint64_t kLitSteps = 15;

bool isLater(double due, std::uint64_t order, double otherDue, std::uint64_t otherOrder)
{
    return due > otherDue || (due == otherDue && order > otherOrder);
}

float flatDistance(const glm::vec3& a, const glm::vec3& b)
{
    const float x = a.x - b.x;
    const float z = a.z - b.z;
    return std::sqrt(x * x + z * z);
}

std::uint64_t cellOf(float x, float z, float size)
{
    const auto column = static_cast<std::int64_t>(std::floor(x / size));
    const auto row = static_cast<std::int64_t>(std::floor(z / size));
    return static_cast<std::uint64_t>(column) * 0x9E3779B97F4A7C15ULL ^
           static_cast<std::uint64_t>(row);
}

} // namespace

void RuleEngine::setRules(const model::Scene& scene)
{
    std::vector<model::Rule> rules;
    for (const model::Rule& rule : scene.rules) {
        if (rule.isEnabled) {
            rules.push_back(rule);
        }
    }
    std::vector<std::vector<Memory>> memory(rules.size());
    std::vector<std::uint32_t> now(m_rules.size(), kNone);
    for (std::size_t i = 0; i < rules.size(); ++i) {
        const auto former = std::ranges::find(m_rules, rules[i].id, &model::Rule::id);
        if (former != m_rules.end()) {
            const auto index = static_cast<std::size_t>(former - m_rules.begin());
            memory[i] = std::move(m_memory[index]);
            // One with other actions begins anew at its next occasion.
            now[index] =
                former->actions == rules[i].actions ? static_cast<std::uint32_t>(i) : kNone;
        }
        memory[i].resize(m_minds.size());
    }
    for (Mind& mind : m_minds) {
        mind.rule = mind.rule == kNone ? kNone : now[mind.rule];
    }
    m_rules = std::move(rules);
    m_memory = std::move(memory);
    m_places = scene.places;
    m_tagNames = scene.tags;
    m_seed = scene.seed;
    m_problems.clear();
}

void RuleEngine::setPeople(const model::Population& people, std::span<const std::uint32_t> keep)
{
    const auto tags = people.column(model::columns::tags);
    std::vector<Mind> minds(keep.size());
    for (std::size_t i = 0; i < keep.size(); ++i) {
        if (keep[i] != PathFollower::kNobody) {
            minds[i] = std::move(m_minds[keep[i]]);
        } else {
            minds[i].tags = tags[i];
        }
    }
    for (std::vector<Memory>& memory : m_memory) {
        std::vector<Memory> kept(keep.size());
        for (std::size_t i = 0; i < keep.size(); ++i) {
            if (keep[i] != PathFollower::kNobody) {
                kept[i] = memory[keep[i]];
            }
        }
        memory = std::move(kept);
    }
    m_minds = std::move(minds);
    m_agentOf.clear();
    for (std::size_t i = 0; i < keep.size(); ++i) {
        m_agentOf.emplace_back(people.ids()[i], static_cast<std::uint32_t>(i));
    }
}

void RuleEngine::setTags(std::uint32_t agent, std::uint64_t tags)
{
    m_minds[agent].tags = tags;
}

void RuleEngine::complain(std::string problem)
{
    if (std::ranges::find(m_problems, problem) == m_problems.end() && m_problems.size() < 50) {
        m_problems.push_back(std::move(problem));
    }
}

std::uint64_t RuleEngine::count(model::RuleId rule) const
{
    const auto found = m_counts.find(rule);
    return found == m_counts.end() ? 0 : found->second;
}

std::vector<RuleFired> RuleEngine::takeLog()
{
    return std::exchange(m_log, {});
}

bool RuleEngine::isLit(std::uint32_t agent, std::uint64_t step) const
{
    const Mind& mind = m_minds[agent];
    return mind.litStep != 0 && step < mind.litStep + kLitSteps;
}

float RuleEngine::draw(RuleHost& host, std::uint32_t agent, std::uint64_t purpose) const
{
    return model::unitFloat(
        model::hashKeys(m_seed, host.id(agent), purpose, m_minds[agent].firings, m_step));
}

void RuleEngine::send(const std::string& event, float payload, std::uint32_t agent,
                      const glm::vec3& origin)
{
    if (agent < m_agentOf.size()) {
        m_events.push_back({m_now, m_order++, event, payload, m_agentOf[agent].first, origin});
        std::ranges::push_heap(m_events, [](const Event& a, const Event& b) {
            return isLater(a.due, a.order, b.due, b.order);
        });
    }
}

void RuleEngine::step(RuleHost& host, std::uint64_t step)
{
    m_step = step;
    m_now = static_cast<double>(step) / 30.0;
    deliver(host);
    lookAround(host);
    for (std::uint32_t agent = 0; agent < m_minds.size(); ++agent) {
        if (m_minds[agent].rule != kNone && !host.isGone(agent)) {
            goOn(host, agent);
        }
    }
}

/// Events that are due, in the order in which they were sent.
void RuleEngine::deliver(RuleHost& host)
{
    const auto later = [](const Event& a, const Event& b) {
        return isLater(a.due, a.order, b.due, b.order);
    };
    const std::uint64_t before = m_order; // what is sent meanwhile waits for the next step
    std::vector<Event> postponed;
    while (!m_events.empty() && m_events.front().due <= m_now) {
        std::ranges::pop_heap(m_events, later);
        Event event = std::move(m_events.back());
        m_events.pop_back();
        if (event.order >= before) {
            postponed.push_back(std::move(event));
            continue;
        }
        const auto found = std::ranges::lower_bound(m_agentOf, event.who, {},
                                                    [](const auto& entry) { return entry.first; });
        if (found == m_agentOf.end() || found->first != event.who || host.isGone(found->second)) {
            continue;
        }
        for (std::uint32_t rule = 0; rule < m_rules.size(); ++rule) {
            const model::Trigger& trigger = m_rules[rule].trigger;
            if (trigger.kind == model::TriggerKind::Event && trigger.event == event.name) {
                fire(host, rule, found->second, {event.payload, event.origin, true});
            }
        }
    }
    for (Event& event : postponed) {
        m_events.push_back(std::move(event));
        std::ranges::push_heap(m_events, later);
    }
}

bool RuleEngine::isInside(RuleHost& host, model::PlaceId place, std::uint32_t agent) const
{
    const auto found = std::ranges::find(m_places, place, &model::Place::id);
    return found != m_places.end() &&
           flatDistance(found->position, host.position(agent)) <= found->radius;
}

bool RuleEngine::happensTo(RuleHost& host, std::uint32_t index, std::uint32_t agent)
{
    const model::Trigger& trigger = m_rules[index].trigger;
    Memory& memory = m_memory[index][agent];
    const std::uint8_t happened = host.happenings(agent);
    switch (trigger.kind) {
    case model::TriggerKind::Start:
        return std::exchange(memory.wasThere, true) == false;
    case model::TriggerKind::Arrived:
        return (happened & PathFollower::ReachedPlace) != 0 &&
               (trigger.place == 0 || host.reachedPlace(agent) == trigger.place);
    case model::TriggerKind::PathEnded:
        return (happened & PathFollower::EndedPath) != 0 &&
               (trigger.path == 0 || host.pathOf(agent) == trigger.path);
    case model::TriggerKind::Entered:
    case model::TriggerKind::Left: {
        bool isThere = false;
        for (const model::Place& place : m_places) {
            isThere = isThere || ((trigger.place == 0 || place.id == trigger.place) &&
                                  isInside(host, place.id, agent));
        }
        const bool wasThere = std::exchange(memory.wasThere, isThere);
        return trigger.kind == model::TriggerKind::Entered ? isThere && !wasThere
                                                           : wasThere && !isThere;
    }
    case model::TriggerKind::Every: {
        const double period = std::max(1.0 / 30.0, static_cast<double>(trigger.seconds));
        const std::uint64_t key =
            model::hashKeys(m_seed, host.id(agent), m_rules[index].id, memory.count, 51);
        if (memory.next < 0.0) {
            memory.next = m_now + period * model::unitDouble(key); // not all at once
            return false;
        }
        if (m_now < memory.next) {
            return false;
        }
        memory.next = m_now + period * (1.0 + static_cast<double>(trigger.jitter) *
                                                  (2.0 * model::unitDouble(key) - 1.0));
        return true;
    }
    case model::TriggerKind::Event:
    case model::TriggerKind::ClipEnded:
    case model::TriggerKind::TagNear:
        break;
    }
    return false;
}

void RuleEngine::lookAt(RuleHost& host, std::uint32_t rule)
{
    for (std::uint32_t agent = 0; agent < m_minds.size(); ++agent) {
        if (!host.isGone(agent) && happensTo(host, rule, agent)) {
            fire(host, rule, agent, {});
        }
    }
}

void RuleEngine::lookForTags(RuleHost& host, std::uint32_t rule)
{
    const model::Trigger trigger = m_rules[rule].trigger;
    const std::uint64_t bit = std::uint64_t{1} << trigger.tag;
    const float size = std::max(0.5F, trigger.metres);
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells;
    for (std::uint32_t agent = 0; agent < m_minds.size(); ++agent) {
        if ((m_minds[agent].tags & bit) != 0 && !host.isGone(agent)) {
            const glm::vec3 at = host.position(agent);
            cells[cellOf(at.x, at.z, size)].push_back(agent);
        }
    }
    for (std::uint32_t agent = 0; agent < m_minds.size(); ++agent) {
        if (host.isGone(agent)) {
            continue;
        }
        const glm::vec3 at = host.position(agent);
        float nearest = trigger.metres;
        std::uint32_t who = kNone;
        for (int side = 0; side < 9 && !cells.empty(); ++side) {
            const auto cell =
                cells.find(cellOf(at.x + static_cast<float>(side % 3 - 1) * size,
                                  at.z + static_cast<float>(side / 3 - 1) * size, size));
            for (const std::uint32_t other :
                 cell == cells.end() ? std::vector<std::uint32_t>() : cell->second) {
                const float away = flatDistance(host.position(other), at);
                if (other != agent && (away < nearest || (away == nearest && other < who))) {
                    nearest = away;
                    who = other;
                }
            }
        }
        const bool isNear = who != kNone;
        if (std::exchange(m_memory[rule][agent].wasThere, isNear) != isNear && isNear) {
            fire(host, rule, agent, {0.0F, host.position(who), true});
        }
    }
}

void RuleEngine::lookAround(RuleHost& host)
{
    for (std::uint32_t rule = 0; rule < m_rules.size(); ++rule) {
        const model::TriggerKind kind = m_rules[rule].trigger.kind;
        if (kind == model::TriggerKind::TagNear) {
            lookForTags(host, rule);
        } else if (kind != model::TriggerKind::Event && kind != model::TriggerKind::ClipEnded) {
            lookAt(host, rule);
        }
    }
}

bool RuleEngine::holds(RuleHost& host, const model::Condition& condition, std::uint64_t key,
                       std::uint32_t agent) const
{
    switch (condition.kind) {
    case model::ConditionKind::HasTag:
        return (m_minds[agent].tags >> condition.tag & 1U) != 0;
    case model::ConditionKind::OfTemplate:
        return host.templateOf(agent) == condition.templateId;
    case model::ConditionKind::InPlace:
        return isInside(host, condition.place, agent);
    case model::ConditionKind::FollowsPath:
        return condition.path == 0 ? host.pathOf(agent) != 0 : host.pathOf(agent) == condition.path;
    case model::ConditionKind::IsSeated:
        return host.isSeated(agent);
    case model::ConditionKind::Chance:
        return draw(host, agent, key) < condition.chance;
    }
    return false;
}

bool RuleEngine::holds(RuleHost& host, const model::Rule& rule, std::uint32_t agent) const
{
    bool isAny = rule.conditions.empty();
    bool areAll = true;
    for (std::size_t i = 0; i < rule.conditions.size(); ++i) {
        const model::Condition& condition = rule.conditions[i];
        const bool isTrue =
            holds(host, condition, model::hashKeys(rule.id, i, 61), agent) != condition.isNot;
        isAny = isAny || isTrue;
        areAll = areAll && isTrue;
    }
    return rule.isAnyEnough ? isAny : areAll;
}

void RuleEngine::fire(RuleHost& host, std::uint32_t index, std::uint32_t agent, const Cause& cause)
{
    const model::Rule& rule = m_rules[index];
    const Memory& memory = m_memory[index][agent];
    Mind& mind = m_minds[agent];
    if (m_now < memory.last + static_cast<double>(rule.cooldownSeconds) ||
        (rule.limit != 0 && memory.count >= rule.limit) || !holds(host, rule, agent)) {
        return;
    }
    if (mind.rule != kNone) {
        if (rule.meeting == model::RuleMeeting::Queue && mind.queue.size() < kMaxQueue) {
            mind.queue.push_back({rule.id, cause});
            return;
        }
        // A rule further up is not interrupted by one further down.
        if (rule.meeting != model::RuleMeeting::Interrupt || mind.rule < index) {
            return;
        }
        host.endClip(agent);
    }
    begin(host, index, agent, cause);
}

void RuleEngine::begin(RuleHost& host, std::uint32_t index, std::uint32_t agent, const Cause& cause)
{
    Mind& mind = m_minds[agent];
    Memory& memory = m_memory[index][agent];
    memory.last = m_now;
    ++memory.count;
    ++mind.firings;
    ++m_counts[m_rules[index].id];
    mind.rule = index;
    mind.action = 0;
    mind.isStarted = false;
    mind.isTravelling = false;
    mind.cause = cause;
    mind.litStep = std::max<std::uint64_t>(1, m_step);
    if (m_log.size() < kMaxLog) {
        m_log.push_back({m_step, m_rules[index].id, host.id(agent)});
    }
}

void RuleEngine::goOn(RuleHost& host, std::uint32_t agent)
{
    Mind& mind = m_minds[agent];
    for (int count = 0; mind.rule != kNone; ++count) {
        const std::vector<model::Action>& actions = m_rules[mind.rule].actions;
        if (count > kMaxActionsAtOnce) {
            complain("Rule \"" + m_rules[mind.rule].name +
                     "\" repeats without any time passing: let it wait or play a clip. It was "
                     "ended.");
            mind.rule = kNone;
            return;
        }
        if (mind.action >= actions.size()) {
            mind.rule = kNone;
            if (!mind.queue.empty()) {
                const Waiting next = mind.queue.front();
                mind.queue.erase(mind.queue.begin());
                const auto rule = std::ranges::find(m_rules, next.rule, &model::Rule::id);
                if (rule != m_rules.end()) {
                    begin(host, static_cast<std::uint32_t>(rule - m_rules.begin()), agent,
                          next.cause);
                }
            }
            continue;
        }
        const std::uint32_t rule = mind.rule;
        if (!run(host, agent, actions[mind.action])) {
            return;
        }
        if (mind.rule == rule) {
            ++mind.action;
            mind.isStarted = false;
            mind.isTravelling = false;
        }
    }
}

bool RuleEngine::play(RuleHost& host, std::uint32_t agent, const model::Action& action)
{
    Mind& mind = m_minds[agent];
    if (mind.isStarted) {
        if (m_now < mind.until) {
            return false;
        }
        host.endClip(agent);
        for (std::uint32_t rule = 0; rule < m_rules.size(); ++rule) {
            if (m_rules[rule].trigger.kind == model::TriggerKind::ClipEnded && rule != mind.rule) {
                mind.queue.push_back({m_rules[rule].id, mind.cause});
            }
        }
        return true;
    }
    float total = 0.0F;
    for (const model::ClipWeight& clip : action.clips) {
        total += clip.weight;
    }
    float drawn = total * draw(host, agent, model::hashKeys(mind.action, 71));
    for (const model::ClipWeight& clip : action.clips) {
        drawn -= clip.weight;
        if (drawn < 0.0F || &clip == &action.clips.back()) {
            const float seconds = host.play(agent, clip.clip, action.isLooped);
            mind.until = m_now + static_cast<double>(action.isLooped ? action.seconds : seconds);
            mind.isStarted = true;
            return seconds < 0.0F; // he has no such clip: on to the next action
        }
    }
    return true;
}

void RuleEngine::travel(RuleHost& host, std::uint32_t agent, const model::Action& action)
{
    Mind& mind = m_minds[agent];
    mind.isStarted = true;
    mind.isTravelling = true;
    const glm::vec3 at = host.position(agent);
    if (action.kind == model::ActionKind::Flee) {
        glm::vec3 away = at - mind.cause.origin;
        away.y = 0.0F;
        const float length = std::sqrt(away.x * away.x + away.z * away.z);
        const float angle = 6.2831853F * draw(host, agent, 81);
        away = mind.cause.hasOrigin && length > 0.05F
                   ? away / length
                   : glm::vec3(std::sin(angle), 0.0F, std::cos(angle));
        host.sendTo(agent, at + away * action.metres);
        return;
    }
    const auto place = std::ranges::find(m_places, action.place, &model::Place::id);
    if (place == m_places.end()) {
        complain("Rule \"" + m_rules[mind.rule].name +
                 "\" sends people to a place that is not there any more. Choose another one.");
        mind.isTravelling = false;
        mind.until = m_now;
        return;
    }
    const float radius =
        place->radius * std::sqrt(draw(host, agent, model::hashKeys(place->id, 82)));
    const float angle = 6.2831853F * draw(host, agent, model::hashKeys(place->id, 83));
    host.sendTo(agent,
                place->position + radius * glm::vec3(std::sin(angle), 0.0F, std::cos(angle)));
}

void RuleEngine::send(RuleHost& host, std::uint32_t agent, const model::Action& action)
{
    if (m_events.size() > kMaxEvents) {
        complain("There are too many events under way; further ones are dropped. A rule may be "
                 "sending events that make it send again: give it a cooldown or a limit.");
        return;
    }
    const glm::vec3 at = host.position(agent);
    for (std::uint32_t other = 0; other < m_minds.size(); ++other) {
        const float away = flatDistance(host.position(other), at);
        bool isMeant = other != agent && !host.isGone(other);
        switch (action.reach) {
        case model::EventReach::Self:
            isMeant = other == agent;
            break;
        case model::EventReach::Near:
            isMeant = isMeant && away <= action.metres;
            break;
        case model::EventReach::Tagged:
            isMeant = isMeant && (m_minds[other].tags >> action.tag & 1U) != 0;
            break;
        case model::EventReach::Group:
            isMeant = isMeant && host.group(other) == host.group(agent);
            break;
        case model::EventReach::Everybody:
            break;
        }
        if (isMeant) {
            const double delay = static_cast<double>(away * action.secondsPerMetre);
            m_events.push_back(
                {m_now + delay, m_order++, action.event, action.value, host.id(other), at});
            std::ranges::push_heap(m_events, [](const Event& a, const Event& b) {
                return isLater(a.due, a.order, b.due, b.order);
            });
        }
    }
}

bool RuleEngine::run(RuleHost& host, std::uint32_t agent, const model::Action& action)
{
    Mind& mind = m_minds[agent];
    switch (action.kind) {
    case model::ActionKind::PlayClip:
        return play(host, agent, action);
    case model::ActionKind::FollowPath:
        if (!host.follow(agent, action.path)) {
            complain("Rule \"" + m_rules[mind.rule].name +
                     "\" lets people follow a path that is not there any more. Choose another "
                     "one.");
        }
        return true;
    case model::ActionKind::GoToPlace:
    case model::ActionKind::Flee:
        if (!mind.isStarted) {
            travel(host, agent, action);
            return !mind.isTravelling;
        }
        return (host.happenings(agent) & PathFollower::EndedErrand) != 0;
    case model::ActionKind::Stop:
        host.stop(agent);
        return true;
    case model::ActionKind::GoOn:
        host.goOn(agent);
        return true;
    case model::ActionKind::Wait:
        if (!mind.isStarted) {
            mind.isStarted = true;
            const float share = 0.5F + draw(host, agent, model::hashKeys(mind.action, 91));
            mind.until = m_now + static_cast<double>(action.seconds * share);
        }
        return m_now >= mind.until;
    case model::ActionKind::SetSpeed:
        host.setPace(agent, action.value > 0.0F ? action.value : mind.cause.payload);
        return true;
    case model::ActionKind::TurnTo: {
        const auto place = std::ranges::find(m_places, action.place, &model::Place::id);
        if (place != m_places.end()) {
            host.turnTo(agent, place->position);
        } else if (mind.cause.hasOrigin) {
            host.turnTo(agent, mind.cause.origin);
        }
        return true;
    }
    case model::ActionKind::AddTag:
        mind.tags |= std::uint64_t{1} << action.tag;
        return true;
    case model::ActionKind::RemoveTag:
        mind.tags &= ~(std::uint64_t{1} << action.tag);
        return true;
    case model::ActionKind::SendEvent:
        send(host, agent, action);
        return true;
    case model::ActionKind::LeaveScene:
        host.leave(agent);
        return true;
    case model::ActionKind::Again:
        mind.action = kNone; // the step to the next one makes it the first
        return true;
    }
    return true;
}

} // namespace crowd::behavior
