// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "model/population/Columns.h"
#include "model/rules/Rule.h"

namespace crowd::behavior {

/// "A rule fired", for the artist's log.
struct RuleFired
{
    double seconds = 0.0; ///< since the session began
    model::RuleId rule = 0;
    model::IndividualId who = 0;
    friend bool operator==(const RuleFired&, const RuleFired&) = default;
};

/// Which rules fired for whom, for the artist to see: counted, listed, and highlighted for half a
/// second.
class FiringLog
{
public:
    void add(const RuleFired& fired, std::uint32_t agent);
    /// Ends highlights whose time is over.
    void update(double now);
    /// See AgentStates::setPeople.
    void setPeople(std::span<const std::uint32_t> keep);

    /// How often a rule fired.
    [[nodiscard]] std::uint64_t count(model::RuleId rule) const;
    [[nodiscard]] const std::map<model::RuleId, std::uint64_t>& counts() const { return m_counts; }
    /// What fired since the last call, at most some thousand entries.
    [[nodiscard]] std::vector<RuleFired> take();
    /// Agents, ascending.
    [[nodiscard]] std::vector<std::uint32_t> highlighted() const;

private:
    std::map<model::RuleId, std::uint64_t> m_counts;
    std::vector<RuleFired> m_entries;
    std::vector<double> m_highlightedUntil;   ///< by agent, seconds; below 0: is not
    std::vector<std::uint32_t> m_highlighted; ///< agents, in any order
};

} // namespace crowd::behavior
