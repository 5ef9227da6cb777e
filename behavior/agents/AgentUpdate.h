// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "behavior/agents/AgentColumns.h"
#include "behavior/agents/ClipAnimation.h"
#include "behavior/agents/GroundContact.h"
#include "behavior/agents/SessionClock.h"
#include "behavior/crowd/CrowdSimulation.h"
#include "model/population/Population.h"

namespace crowd::behavior {

/// Takes a step of the crowd over into what is shown: position, heading, speed, gait and clip. Most
/// agents go through the stride kernel, many at once; those that need a full update are done one by
/// one. Refers to the others; called by one thread, works on all cores.
class AgentUpdate
{
public:
    AgentUpdate(const model::Population& people, const SessionClock& clock, AgentColumns& agents,
                CrowdSimulation& crowd, GroundContact& ground, ClipAnimation& animation);

    /// Before the crowd's step: agents that want to stand still come to rest with their feet
    /// together, in a step or two rather than at once.
    void brake();
    /// After the crowd's step.
    void updateAll();

private:
    void updateBlock(std::size_t begin, std::size_t end);
    void updateAgent(std::uint32_t agent);
    [[nodiscard]] bool placeBody(std::uint32_t agent);
    void turn(std::uint32_t agent, float metresPerSecond);

    const model::Population& m_people;
    const SessionClock& m_clock;
    AgentColumns& m_agents;
    CrowdSimulation& m_crowd;
    GroundContact& m_ground;
    ClipAnimation& m_animation;
    float m_smoothing; ///< share of a change of speed that is shown in a step
};

} // namespace crowd::behavior
