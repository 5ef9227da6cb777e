// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "behavior/rules/RuleEngine.h"

/// How events are sent, travel and are heard.
namespace crowd::behavior {

namespace {

constexpr std::size_t kMaxEvents = 500'000;

} // namespace

void RuleEngine::post(Event event)
{
    m_events.push_back(std::move(event));
    std::ranges::push_heap(m_events, isLater);
}

void RuleEngine::send(const std::string& event, float payload, std::uint32_t agent,
                      const glm::vec3& origin)
{
    if (agent < m_agentOf.size() && std::isfinite(payload)) {
        post({m_now, m_order++, event, payload, m_agentOf[agent].first, origin, 0});
    }
}

/// Said once in a step: there may be very many whom it holds up.
void RuleEngine::sayStorm(std::uint32_t rule)
{
    if (!std::exchange(m_isStormSaid, true)) {
        complain({"There is more for rules to do at once than a step has room for; characters act "
                  "later, and events beyond half a million are dropped. Let rules send events to "
                  "fewer characters, wait in between, or come less often.",
                  rule == kNone ? 0 : m_rules[rule].id});
    }
}

/// Events that are due, in the order in which they were sent.
void RuleEngine::deliver(RuleHost& host)
{
    const std::uint64_t before = m_order; // what is sent meanwhile waits for the next step
    std::vector<Event> postponed;
    while (!m_events.empty() && m_events.front().due <= m_now) {
        if (m_left.heard == 0) {
            sayStorm(kNone);
            break;
        }
        --m_left.heard;
        std::ranges::pop_heap(m_events, isLater);
        Event event = std::move(m_events.back());
        m_events.pop_back();
        if (event.order >= before) {
            postponed.push_back(std::move(event));
            continue;
        }
        const std::uint32_t agent = agentNamed(event.who);
        if (agent != kNone) {
            hear(host, agent, event);
        }
    }
    for (Event& event : postponed) {
        post(std::move(event));
    }
}

void RuleEngine::hear(RuleHost& host, std::uint32_t agent, const Event& event)
{
    Mind& mind = m_minds[agent];
    if (mind.rule != kNone && mind.isStarted) {
        const model::Action& action = m_rules[mind.rule].actions[mind.action];
        const auto* wait = action.as<model::actions::WaitForEvent>();
        if (wait != nullptr && wait->event == event.name) {
            mind.hasHeard = true;
            mind.cause = {event.payload, event.origin, true, event.sender};
        }
    }
    for (std::uint32_t rule = 0; rule < m_rules.size(); ++rule) {
        const auto* trigger = m_rules[rule].trigger.as<model::triggers::Event>();
        if (trigger != nullptr && trigger->event == event.name &&
            (m_bringsBack[rule] || !host.isGone(agent))) {
            fire(host, rule, agent, {event.payload, event.origin, true, event.sender});
        }
    }
}

bool RuleEngine::isMeant(RuleHost& host, const model::actions::SendEvent& action,
                         std::uint32_t agent, std::uint32_t other) const
{
    if (action.reach == model::EventReach::Self) {
        return other == agent;
    }
    if (other == agent) {
        return false;
    }
    switch (action.reach) {
    case model::EventReach::Near:
        return !host.isGone(other) &&
               flatDistance(host.position(other), host.position(agent)) <= action.metres;
    case model::EventReach::Tagged:
        return (m_minds[other].tags >> action.tag & 1U) != 0;
    case model::EventReach::Group:
        return host.group(other) == host.group(agent);
    case model::EventReach::Self:
    case model::EventReach::Everybody:
        break;
    }
    return true;
}

void RuleEngine::fillCells(RuleHost& host)
{
    for (std::uint32_t agent = 0; m_cells.isEmpty() && agent < m_minds.size(); ++agent) {
        m_cells.add(agent, host.position(agent));
    }
}

void RuleEngine::fillGroups(RuleHost& host)
{
    for (std::uint32_t agent = 0; agent < m_minds.size(); ++agent) {
        m_groups[host.group(agent)].push_back(agent);
    }
}

std::vector<std::uint32_t>& RuleEngine::carriersOf(std::uint8_t tag)
{
    const auto [entry, isNew] = m_carriers.try_emplace(tag);
    for (std::uint32_t agent = 0; isNew && agent < m_minds.size(); ++agent) {
        if ((m_minds[agent].tags >> tag & 1U) != 0) {
            entry->second.push_back(agent);
        }
    }
    return entry->second;
}

const std::vector<std::uint32_t>* RuleEngine::findMeant(RuleHost& host, std::uint32_t agent,
                                                        const model::actions::SendEvent& action)
{
    switch (action.reach) {
    case model::EventReach::Self:
        m_meant = {agent};
        return &m_meant;
    case model::EventReach::Near:
        fillCells(host);
        return m_cells.gather(host.position(agent), action.metres, m_meant) ? &m_meant : nullptr;
    case model::EventReach::Tagged:
        return &carriersOf(action.tag);
    case model::EventReach::Group:
        if (m_groups.empty()) {
            fillGroups(host);
        }
        return &m_groups[host.group(agent)];
    case model::EventReach::Everybody:
        break;
    }
    return nullptr;
}

void RuleEngine::tell(RuleHost& host, std::uint32_t agent, std::uint32_t other,
                      const model::actions::SendEvent& action)
{
    const glm::vec3 at = host.position(agent);
    const float away = host.isGone(other) ? 0.0F : flatDistance(host.position(other), at);
    const double delay = static_cast<double>(away * action.secondsPerMetre);
    post(
        {m_now + delay, m_order++, action.event, action.value, host.id(other), at, host.id(agent)});
}

void RuleEngine::send(RuleHost& host, std::uint32_t agent, const model::actions::SendEvent& action)
{
    const std::vector<std::uint32_t>* meant = findMeant(host, agent, action);
    const std::size_t asked = meant != nullptr ? meant->size() : m_minds.size();
    if (m_events.size() > kMaxEvents || m_left.asked < asked) {
        if (!std::exchange(m_isStormSaid, true)) {
            complainOf(m_minds[agent].rule,
                       " sends more events than can be under way; further ones are dropped. It may "
                       "be sending events that make it send again: give it a pause, or say how "
                       "often at most.");
        }
        return;
    }
    m_left.asked -= asked;
    for (std::size_t i = 0; i < asked; ++i) {
        const std::uint32_t other = meant != nullptr ? (*meant)[i] : static_cast<std::uint32_t>(i);
        if (isMeant(host, action, agent, other)) {
            tell(host, agent, other, action);
        }
    }
}

} // namespace crowd::behavior
