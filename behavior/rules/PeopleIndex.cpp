// SPDX-License-Identifier: MIT
#include "behavior/rules/PeopleIndex.h"

#include <algorithm>
#include <limits>

namespace crowd::behavior {

NearCells cellsOfTagged(const RuleHost& host, const AgentStates& agents, std::uint8_t tag)
{
    NearCells cells;
    for (std::uint32_t agent = 0; agent < agents.size(); ++agent) {
        if (agents.hasTag(agent, tag) && !host.isGone(agent)) {
            cells.add(agent, host.position(agent));
        }
    }
    return cells;
}

void PeopleIndex::clear()
{
    m_cells.clear();
    m_groups.clear();
    m_carriers.clear();
    m_tagged.clear();
}

const std::vector<std::uint32_t>& PeopleIndex::only(std::uint32_t agent)
{
    m_few = {agent};
    return m_few;
}

const std::vector<std::uint32_t>& PeopleIndex::these(std::vector<std::uint32_t> agents)
{
    m_few = std::move(agents);
    return m_few;
}

const std::vector<std::uint32_t>* PeopleIndex::near(const RuleHost& host, std::uint32_t agent,
                                                    float metres)
{
    if (m_cells.isEmpty()) {
        for (std::uint32_t other = 0; other < host.agents(); ++other) {
            m_cells.add(other, host.position(other));
        }
    }
    return m_cells.gather(host.position(agent), metres, m_few) ? &m_few : nullptr;
}

const std::vector<std::uint32_t>& PeopleIndex::withTag(const AgentStates& agents, std::uint8_t tag)
{
    const auto [entry, isNew] = m_carriers.try_emplace(tag);
    for (std::uint32_t agent = 0; isNew && agent < agents.size(); ++agent) {
        if (agents.hasTag(agent, tag)) {
            entry->second.push_back(agent);
        }
    }
    return entry->second;
}

const std::vector<std::uint32_t>& PeopleIndex::inGroup(const RuleHost& host, std::uint32_t group)
{
    if (m_groups.empty()) {
        for (std::uint32_t agent = 0; agent < host.agents(); ++agent) {
            m_groups[host.group(agent)].push_back(agent);
        }
    }
    return m_groups[group];
}

std::uint32_t PeopleIndex::nearestTagged(const RuleHost& host, const AgentStates& agents,
                                         std::uint32_t agent, std::uint8_t tag)
{
    const auto [entry, isNew] = m_tagged.try_emplace(tag);
    if (isNew) {
        entry->second = cellsOfTagged(host, agents, tag);
    }
    return entry->second.nearest(host.position(agent), std::numeric_limits<float>::max(), agent);
}

void PeopleIndex::noteTag(std::uint32_t agent, std::uint8_t tag)
{
    const auto known = m_carriers.find(tag);
    if (known == m_carriers.end()) {
        return;
    }
    std::vector<std::uint32_t>& carriers = known->second;
    const auto at = std::ranges::lower_bound(carriers, agent);
    if (at == carriers.end() || *at != agent) {
        carriers.insert(at, agent);
    }
}

void PeopleIndex::noteAppeared(std::uint32_t agent, const glm::vec3& position)
{
    if (!m_cells.isEmpty()) {
        m_cells.add(agent, position);
    }
}

} // namespace crowd::behavior
