// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "behavior/crowd/AgentRows.h"
#include "behavior/crowd/BinLattice.h"
#include "behavior/crowd/Body.h"
#include "behavior/crowd/ForceParameters.h"
#include "behavior/crowd/LongBodies.h"
#include "behavior/crowd/WallField.h"

namespace crowd::behavior {

struct ForceJob;

/// One of the crowd, as seen from above: (x, z), metres, metres per second.
struct AgentState
{
    glm::vec2 position{0.0F};
    glm::vec2 velocity{0.0F};
    float groundHeight = 0.0F;
    float radius = 0.25F;
    float preferredSpeed = 1.3F; ///< 0: does not move and is an obstacle
};

/// Bodies that avoid each other and walls while they go where they are told to. Knows nothing of
/// paths, clips or scenes. The same bits for any number of threads and for any order in which
/// people came to where they are. One thread at a time calls it.
class CrowdSimulation
{
public:
    ForceParameters parameters;

    /// Agent i is agents[i]; some of them have long bodies. Values that are no numbers become
    /// harmless ones.
    void setAgents(std::span<const AgentState> agents, std::span<const LongBody> longBodies = {});
    /// Bodies beside the agents that are where they are put, whatever is near: agents make way for
    /// them. Before each step anew; setAgents() takes them away.
    void setPuppets(std::span<const AgentState> puppets);
    void setWalls(std::span<const Wall> walls);
    [[nodiscard]] std::size_t size() const { return m_agents; }
    /// Write where they are turned between steps.
    [[nodiscard]] std::span<LongBody> longBodies() { return m_longBodies.bodies(); }

    /// By agent. Between steps write what they desire; positions to let somebody jump; preferred
    /// speeds to let somebody stop.
    [[nodiscard]] std::span<Body> bodies() { return {m_bodies.data(), m_agents}; }
    [[nodiscard]] std::span<const Body> bodies() const { return {m_bodies.data(), m_agents}; }
    /// Of the ground underfoot, by agent, metres; write them where it is not flat.
    [[nodiscard]] std::span<float> heights() { return {m_heights.data(), size()}; }
    [[nodiscard]] std::span<const float> heights() const { return {m_heights.data(), size()}; }
    void setLevels(bool hasLevels) { m_hasLevels = hasLevels; }

    /// Moves everybody on by `seconds` (at most 0.1; nothing happens at 0 or less).
    void step(float seconds);

    /// Memory held, without walls.
    [[nodiscard]] std::size_t bytes() const;

private:
    void layOutWalls();
    void gather();
    void separate(const ForceJob& before, float aside);
    void takeMoved();
    void scatter();

    std::size_t m_agents = 0;
    std::vector<Body> m_bodies; ///< agents, the discs of long bodies, puppets
    std::size_t m_puppets = 0;  ///< the last of them
    LongBodies m_longBodies;
    float m_widest = 0.0F;        ///< radius, metres
    std::vector<float> m_heights; ///< and spare ones for a whole block of lanes
    AgentRows m_rows;             ///< the same people while they step
    std::vector<float> m_nextX;   ///< of the rows
    std::vector<float> m_nextZ;
    std::vector<float> m_velocityX;
    std::vector<float> m_velocityZ;
    std::vector<float> m_slack;         ///< see ForceJob
    std::vector<std::uint32_t> m_moved; ///< rows that separate() moved, from where a chunk begins
    std::vector<std::size_t> m_movedIn; ///< how many of each chunk
    BinLattice m_lattice;
    std::vector<Wall> m_wallList;
    WallField m_walls;
    float m_wallReach = 0.0F;
    bool m_hasLevels = false;
};

/// Pairs closer than `metres` (below the range of the parameters), on the same level.
[[nodiscard]] std::size_t countPairsCloserThan(const CrowdSimulation& crowd, float metres);

} // namespace crowd::behavior
