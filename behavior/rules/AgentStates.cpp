// SPDX-License-Identifier: MIT
#include "behavior/rules/AgentStates.h"

#include <algorithm>
#include <cstring>

namespace crowd::behavior {

std::uint32_t AgentStates::agentNamed(model::IndividualId id) const
{
    const auto found = std::ranges::lower_bound(m_ids, id);
    return found != m_ids.end() && *found == id ? static_cast<std::uint32_t>(found - m_ids.begin())
                                                : kNoAgent;
}

void AgentStates::setPeople(std::span<const model::IndividualId> ids,
                            std::span<const std::uint64_t> tags,
                            std::span<const std::uint32_t> keep)
{
    rearrange(m_states, keep);
    m_isBusy.resize(m_states.size());
    m_ids.assign(ids.begin(), ids.end());
    for (std::uint32_t agent = 0; agent < m_states.size(); ++agent) {
        if (keep[agent] == kNoAgent) {
            m_states[agent].tags = tags[agent];
        }
        setRule(agent, m_states[agent].rule);
    }
}

void AgentStates::setRule(std::uint32_t agent, std::uint32_t rule)
{
    m_states[agent].rule = rule;
    m_isBusy[agent] = rule != kNoRule ? 1 : 0;
}

std::uint32_t AgentStates::nextBusy(std::uint32_t agent) const
{
    if (agent >= m_isBusy.size()) {
        return static_cast<std::uint32_t>(m_isBusy.size()); // nobody at all, perhaps
    }
    const std::uint8_t* from = m_isBusy.data() + agent;
    const void* found = std::memchr(from, 1, m_isBusy.size() - agent);
    return found == nullptr
               ? static_cast<std::uint32_t>(m_isBusy.size())
               : agent + static_cast<std::uint32_t>(static_cast<const std::uint8_t*>(found) - from);
}

} // namespace crowd::behavior
