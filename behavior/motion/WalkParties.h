// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace crowd::behavior {

/// People of a group who walk the same path keep together: who is ahead waits a little, who is
/// behind hurries, and all walk at the mean of their paces. Gathered anew in every step, in the
/// order of agents, which is the same for any number of threads. Metres, m/s.
class WalkParties
{
public:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

    /// One group's members on its path, in this step.
    struct Party
    {
        std::uint32_t route = 0;
        std::uint32_t members = 0;
        glm::vec2 middle{0.0F};
        float pace = 0.0F;    ///< mean
        bool isClose = false; ///< related: beside each other where there is room
    };

    /// Group of each agent, 0: none; from model::kRelatedParty on, related people. Returns the
    /// party of each agent, or kNone.
    [[nodiscard]] std::vector<std::uint32_t> setGroups(std::span<const std::uint32_t> groups);
    [[nodiscard]] bool isEmpty() const { return m_parties.empty(); }

    void beginStep();
    /// A member on its way. The route of the first one is that of the party.
    void add(std::uint32_t party, std::uint32_t route, const glm::vec2& at, float pace);
    void endStep();

    /// Null: whoever is of that party on that route walks alone.
    [[nodiscard]] const Party* find(std::uint32_t party, std::uint32_t route) const;
    /// Speed and sideways velocity of a member who walks that way, so that they keep together.
    static void keepTogether(const Party& party, const glm::vec2& at, const glm::vec2& ahead,
                             float& speed, glm::vec2& sideways);

private:
    std::vector<Party> m_parties;
    std::vector<char> m_areClose; ///< by party
};

} // namespace crowd::behavior
