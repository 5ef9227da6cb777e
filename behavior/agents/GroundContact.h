// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "behavior/agents/AgentColumns.h"
#include "behavior/crowd/CrowdSimulation.h"
#include "behavior/surface/WalkSurface.h"

namespace crowd::behavior {

/// Keeps agents that walk on the part of the surface that they walk on, at the height of what is
/// underfoot. Refers to the others. update() may be called for different agents at the same time.
class GroundContact
{
public:
    /// `rampShare` of the way to the ground's height is covered in a step.
    GroundContact(const AgentColumns& agents, CrowdSimulation& crowd, float rampShare)
        : m_agents(agents), m_crowd(crowd), m_rampShare(rampShare)
    {
    }

    /// Null: open ground, where there is nothing to do.
    void setSurface(std::shared_ptr<const WalkSurface> surface);
    [[nodiscard]] bool hasSurface() const { return m_surface != nullptr; }
    /// Agents are others, or were put somewhere.
    void reset(std::size_t agents) { m_states.assign(agents, {}); }
    /// Once in a step, after bodies have moved; there is a surface.
    void update(std::uint32_t agent);

private:
    struct State
    {
        Footing footing;
        bool isSettled = true; ///< at the ground's height, or where the scene has put it
    };
    [[nodiscard]] float heightAhead(const Body& body, float height, float surfaceHeight) const;

    const AgentColumns& m_agents;
    CrowdSimulation& m_crowd;
    float m_rampShare;
    std::shared_ptr<const WalkSurface> m_surface;
    std::vector<State> m_states;
};

} // namespace crowd::behavior
