// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "behavior/agents/AgentColumns.h"
#include "behavior/agents/PropertyOverrides.h"
#include "behavior/agents/SessionClock.h"
#include "behavior/agents/TemplateTables.h"
#include "model/population/Population.h"

namespace crowd::behavior {

/// The clip that each agent plays by the clock while it stands or sits: the scene's, one that goes
/// with its posture, or one that a rule has set, with playback speed and phase. What rules set is
/// noted among the overrides. Refers to the others; one thread, reading on any during a step.
class IdleClips
{
public:
    IdleClips(const model::Population& people, const TemplateTables& templates,
              const SessionClock& clock, AgentColumns& agents, PropertyOverrides& overrides)
        : m_people(people), m_templates(templates), m_clock(clock), m_agents(agents),
          m_overrides(overrides)
    {
    }

    void assign(std::size_t agents) { m_states.assign(agents, {}); }
    void rearrange(std::span<const std::uint32_t> keep) { behavior::rearrange(m_states, keep); }

    [[nodiscard]] std::uint16_t clip(std::uint32_t agent) const; ///< as the clip column counts
    [[nodiscard]] float rate(std::uint32_t agent) const;         ///< playback speed
    [[nodiscard]] double phase(std::uint32_t agent) const;       ///< place in it at time 0

    /// Begins now; one that the template has not, or that is played already, changes nothing.
    void setClip(std::uint32_t agent, std::string_view name);
    /// Goes on from where it is.
    void setRate(std::uint32_t agent, float rate);
    /// Is at that place now, 0..1.
    void setPlace(std::uint32_t agent, double place);
    /// As in an earlier run: a clip that a rule has set, which does not begin anew.
    void resumeClip(std::uint32_t agent, std::uint16_t clip);
    /// The place in it at time 0, that a rule has set.
    void setPhase(std::uint32_t agent, float phase);
    /// A clip for another posture (-1: the scene's); one that a rule has set counts no more.
    void setPosture(std::uint32_t agent, int clip);
    /// The scene's clip or the posture's counts again.
    void reset(std::uint32_t agent) { m_states[agent].clip = -1; }
    /// The scene's value of one of the three columns counts again; other columns are passed over.
    void forget(std::uint32_t agent, model::ColumnId column);

private:
    struct State
    {
        int clip = -1;             ///< -1: the scene's
        std::optional<float> rate; ///< nothing: the scene's
        std::optional<double> phase;
    };
    /// Place in it now, in loops since time 0.
    [[nodiscard]] double place(std::uint32_t agent) const;

    const model::Population& m_people;
    const TemplateTables& m_templates;
    const SessionClock& m_clock;
    AgentColumns& m_agents;
    PropertyOverrides& m_overrides;
    std::vector<State> m_states;
};

} // namespace crowd::behavior
