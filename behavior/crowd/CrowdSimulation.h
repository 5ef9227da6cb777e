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

    /// Agent i is agents[i]. Values that are no numbers become harmless ones.
    void setAgents(std::span<const AgentState> agents);
    void setWalls(std::span<const Wall> walls);
    [[nodiscard]] std::size_t size() const { return m_bodies.size(); }

    /// By agent. Between steps write what they desire; positions to let somebody jump; preferred
    /// speeds to let somebody stop.
    [[nodiscard]] std::span<Body> bodies() { return m_bodies; }
    [[nodiscard]] std::span<const Body> bodies() const { return m_bodies; }
    /// Of the ground underfoot, by agent, metres; write them where it is not flat.
    [[nodiscard]] std::span<float> heights() { return {m_heights.data(), size()}; }
    [[nodiscard]] std::span<const float> heights() const { return {m_heights.data(), size()}; }
    void setLevels(bool hasLevels) { m_hasLevels = hasLevels; }

    /// Moves everybody on by `seconds` (at most 0.1; nothing happens at 0 or less).
    void step(float seconds);

    /// Memory held, without walls.
    [[nodiscard]] std::size_t bytes() const;

private:
    void gather();
    void separate(const ForceJob& before, float aside);
    void takeMoved();
    void scatter();

    std::vector<Body> m_bodies;
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
    WallField m_walls;
    bool m_hasLevels = false;
};

/// Pairs closer than `metres` (below the range of the parameters), on the same level.
[[nodiscard]] std::size_t countPairsCloserThan(const CrowdSimulation& crowd, float metres);

} // namespace crowd::behavior
