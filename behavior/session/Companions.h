// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "behavior/base/Agents.h"
#include "model/scene/Scene.h"

namespace crowd::behavior {

class RuleHost;
struct SessionParts;

/// What people who are related do by themselves, as long as no rule has them do something else:
/// followers go after their leader, who are to keep apart give way to each other, who stand near
/// each other turn to each other. Agents, metres; serial, in the order of agents, so that it is the
/// same for any number of threads.
class Companions
{
public:
    /// Of the agents that these people are, row by row. Who was on the way after somebody and is no
    /// more a follower stops by himself.
    void read(const model::Scene& scene);
    [[nodiscard]] bool isEmpty() const { return m_kept.empty(); }
    /// Before the crowd's step, once paths and rules have said where everybody wants to go.
    void step(SessionParts& parts, RuleHost& host);

private:
    /// Somebody, and those to whom he is related by a kind that does something.
    struct Tie
    {
        std::uint32_t other = 0;
        float metres = 0.0F;
        model::RelationWalk walk = model::RelationWalk::Own; ///< Behind: other is the leader
        float faceMetres = 0.0F;                             ///< 0: they do not face each other
    };
    struct Kept
    {
        std::uint32_t agent = 0;
        std::uint32_t firstTie = 0;
        std::uint32_t ties = 0;
        bool isFollowing = false; ///< he has been sent after somebody
    };

    [[nodiscard]] std::uint32_t leaderOf(const Kept& kept, const RuleHost& host,
                                         float& metres) const;
    void follow(Kept& kept, SessionParts& parts, RuleHost& host) const;
    void keepApart(const Kept& kept, SessionParts& parts) const;
    void face(const Kept& kept, const SessionParts& parts, RuleHost& host) const;

    std::vector<Kept> m_kept; ///< ascending agents
    std::vector<Tie> m_ties;
};

} // namespace crowd::behavior
