// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "behavior/rules/AgentStates.h"
#include "behavior/rules/NearCells.h"
#include "behavior/rules/RuleHost.h"

namespace crowd::behavior {

/// Whom rules find by where they are, by tag and by group, without asking everybody. Each part is
/// filled when a rule first asks for it in a step and holds for the rest of that step. Agents,
/// ascending; metres.
class PeopleIndex
{
public:
    /// People have moved.
    void clear();
    /// That one alone. Valid until the next call, as what near() returns.
    [[nodiscard]] const std::vector<std::uint32_t>& only(std::uint32_t agent);
    [[nodiscard]] const std::vector<std::uint32_t>& these(std::vector<std::uint32_t> agents);
    /// All who can be within so many metres of him, and some who are not; null: it is shorter to
    /// ask everybody.
    [[nodiscard]] const std::vector<std::uint32_t>* near(const RuleHost& host, std::uint32_t agent,
                                                         float metres);
    [[nodiscard]] const std::vector<std::uint32_t>& withTag(const AgentStates& agents,
                                                            std::uint8_t tag);
    [[nodiscard]] const std::vector<std::uint32_t>& inGroup(const RuleHost& host,
                                                            std::uint32_t group);
    /// Whoever is here and has the tag and is nearest; kNoAgent: nobody else has it.
    [[nodiscard]] std::uint32_t nearestTagged(const RuleHost& host, const AgentStates& agents,
                                              std::uint32_t agent, std::uint8_t tag);
    /// Somebody has got a tag in this step.
    void noteTag(std::uint32_t agent, std::uint8_t tag);
    /// Somebody has come back in this step.
    void noteAppeared(std::uint32_t agent, const glm::vec3& position);

private:
    NearCells m_cells;
    std::vector<std::uint32_t> m_few; ///< of only() and near()
    std::map<std::uint32_t, std::vector<std::uint32_t>> m_groups;
    std::map<std::uint8_t, std::vector<std::uint32_t>> m_carriers; ///< by tag
    std::map<std::uint8_t, NearCells> m_tagged;                    ///< by tag
};

/// All who are here and have the tag, by where they are.
[[nodiscard]] NearCells cellsOfTagged(const RuleHost& host, const AgentStates& agents,
                                      std::uint8_t tag);

} // namespace crowd::behavior
