// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "behavior/crowd/Body.h"
#include "behavior/crowd/WallField.h"

namespace crowd::behavior {

/// A body that is longer than it is wide: its disc, moved so far to the front and to the back along
/// the way it is turned. Metres.
struct LongBody
{
    std::uint32_t agent = 0;
    float front = 0.0F;
    float back = 0.0F;
    float headingX = 0.0F; ///< unit vector of where it is turned
    float headingZ = 1.0F;
};

/// Long bodies as rows of discs: during a step each disc is one of the crowd, afterwards all of a
/// body move as one. The discs beside the agent's own lie behind all agents.
class LongBodies
{
public:
    /// Appends their discs to bodies and heights. Bodies that are as long as wide are left out.
    void add(std::span<const LongBody> longBodies, std::vector<Body>& bodies);

    [[nodiscard]] bool isEmpty() const { return m_bodies.empty(); }
    [[nodiscard]] std::span<LongBody> bodies() { return m_bodies; }
    /// Agent whose body somebody in the crowd is a disc of; below 0 as AgentRows::owner.
    /// Whoever came later is nobody's disc.
    [[nodiscard]] std::int32_t owner(std::size_t disc) const
    {
        return disc < m_owners.size() ? m_owners[disc] : static_cast<std::int32_t>(disc);
    }

    /// Before a step: discs to where the bodies are.
    void place(std::span<Body> bodies, std::span<float> heights);
    /// After it: bodies to where their discs got, on the whole, and out of walls.
    void gather(std::span<Body> bodies, std::span<const float> heights, const WallField& walls,
                float seconds) const;

private:
    struct Disc
    {
        std::uint32_t body = 0; ///< among m_bodies
        float along = 0.0F;     ///< metres from the agent's own disc to the front
        float x = 0.0F;         ///< where the step began
        float z = 0.0F;
    };
    std::vector<LongBody> m_bodies;
    std::vector<std::uint32_t> m_first; ///< disc of each body, and the end of the last
    std::vector<Disc> m_discs;
    std::vector<glm::vec2> m_start; ///< of each body's own disc
    std::vector<std::int32_t> m_owners;
    std::size_t m_agents = 0;
};

} // namespace crowd::behavior
