// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "behavior/rules/AgentRuleState.h"

namespace crowd::behavior {

/// The rule state of all agents, who of them is busy with a rule, and which individual each is.
/// Agents count from 0 in the order of ascending ids.
class AgentStates
{
public:
    [[nodiscard]] std::size_t size() const { return m_states.size(); }
    [[nodiscard]] AgentRuleState& operator[](std::uint32_t agent) { return m_states[agent]; }
    [[nodiscard]] const AgentRuleState& operator[](std::uint32_t agent) const
    {
        return m_states[agent];
    }
    [[nodiscard]] std::span<const model::IndividualId> ids() const { return m_ids; }
    /// kNoAgent: he is not here.
    [[nodiscard]] std::uint32_t agentNamed(model::IndividualId id) const;

    /// Agents are other ones now: the new agent i is the former agent keep[i], or a new one with
    /// tags[i] where that is kNoAgent.
    void setPeople(std::span<const model::IndividualId> ids, std::span<const std::uint64_t> tags,
                   std::span<const std::uint32_t> keep);
    /// The rule that he is busy with from now on, or kNoRule.
    void setRule(std::uint32_t agent, std::uint32_t rule);
    /// The first one from there on who is busy with a rule, or their number.
    [[nodiscard]] std::uint32_t nextBusy(std::uint32_t agent) const;

    [[nodiscard]] bool hasTag(std::uint32_t agent, std::uint8_t tag) const
    {
        return (m_states[agent].tags >> tag & 1U) != 0;
    }

private:
    std::vector<AgentRuleState> m_states;
    std::vector<std::uint8_t> m_isBusy; ///< apart, so that the busy ones are found fast
    std::vector<model::IndividualId> m_ids;
};

} // namespace crowd::behavior
