// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "behavior/agents/AgentColumns.h"
#include "behavior/agents/ClipAnimation.h"
#include "behavior/agents/IdleClips.h"
#include "behavior/agents/SessionClock.h"
#include "behavior/motion/PathFollower.h"
#include "model/scene/Scene.h"

namespace crowd::behavior {

/// Who sits on which seat, and how agents sit down and stand up: they walk up to a free seat, cover
/// the last bit past the others, and play the clips for it where their template has them. Seats are
/// read from the stages when somebody first wants one. Refers to the others; one thread.
class Seating
{
public:
    Seating(const TemplateTables& templates, const SessionClock& clock, AgentColumns& agents,
            PathFollower& follower, IdleClips& idle, ClipAnimation& animation)
        : m_templates(templates), m_clock(clock), m_agents(agents), m_follower(follower),
          m_idle(idle), m_animation(animation)
    {
    }

    void assign(std::size_t agents) { m_states.assign(agents, {}); }
    void rearrange(std::span<const std::uint32_t> keep);
    /// Other seats than before, perhaps.
    void setStages(std::vector<model::StageEntry> stages);
    /// As the scene says; `keepsPhase`: how far it has got with sitting down stays.
    void setSeat(std::uint32_t agent, model::SeatId seat, bool keepsPhase);
    /// As in an earlier run.
    void resume(std::uint32_t agent, model::SeatId seat);

    [[nodiscard]] bool hasSeats();
    /// Sends an agent to the nearest free seat within so many metres (0: however far). False: there
    /// is none, and nothing changes.
    bool sit(std::uint32_t agent, float metres);
    /// Begins to stand up: seconds that it takes.
    float standUp(std::uint32_t agent);
    /// Does not sit any more, nor is on its way to a seat.
    void leaveSeat(std::uint32_t agent);
    [[nodiscard]] bool isSeated(std::uint32_t agent) const;
    /// model::kNoSeat also on the way to one.
    [[nodiscard]] model::SeatId shownSeat(std::uint32_t agent) const;
    /// Somebody's seat is not the scene's.
    [[nodiscard]] bool hasChanged() const { return m_hasChanged; }

    /// A step of all who are on their way to a seat.
    void step();

private:
    struct State
    {
        model::SeatId seat = model::kNoSeat; ///< sits there, or is on the way to it
        float blockedSeconds = 0.0F;         ///< without getting on
    };
    void readSeats();
    [[nodiscard]] std::size_t indexOf(model::SeatId seat) const;
    void approach(std::uint32_t agent, float metresAway);
    void settle(std::uint32_t agent, const model::Seat& seat);
    void takeSeat(std::uint32_t agent, const model::Seat& seat);
    void setPosture(std::uint32_t agent, bool isSeated);
    void stepOne(std::uint32_t agent);

    const TemplateTables& m_templates;
    const SessionClock& m_clock;
    AgentColumns& m_agents;
    PathFollower& m_follower;
    IdleClips& m_idle;
    ClipAnimation& m_animation;
    std::vector<model::StageEntry> m_stages;
    std::vector<model::WorldSeat> m_seats; ///< ascending; empty: not read yet, or there are none
    std::vector<bool> m_isTaken;           ///< one per seat
    std::vector<State> m_states;
    std::vector<std::uint32_t> m_sitters; ///< agents on their way to a seat, ascending
    bool m_hasChanged = false;
};

} // namespace crowd::behavior
