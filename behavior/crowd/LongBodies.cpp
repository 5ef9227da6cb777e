// SPDX-License-Identifier: MIT
#include "behavior/crowd/LongBodies.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "behavior/crowd/WallForce.h"

namespace crowd::behavior {

namespace {

constexpr float kDiscSpacing = 1.4F; ///< radii: nobody gets between two of them
constexpr int kMostDiscs = 12;       ///< to each side
constexpr float kWorthADisc = 0.3F;  ///< radii: less does not make a body long
constexpr float kLongest = 20.0F;

/// Discs that cover a way, without the one that it begins with.
int discsAlong(float way, float radius)
{
    return way > kWorthADisc * radius
               ? std::clamp(static_cast<int>(std::ceil(way / (kDiscSpacing * radius))), 1,
                            kMostDiscs)
               : 0;
}

} // namespace

void LongBodies::add(std::span<const LongBody> longBodies, std::vector<Body>& bodies)
{
    m_agents = bodies.size();
    m_bodies.clear();
    m_discs.clear();
    m_first = {0};
    m_owners.assign(m_agents, 0);
    for (std::size_t agent = 0; agent < m_agents; ++agent) {
        m_owners[agent] = static_cast<std::int32_t>(agent);
    }
    for (const LongBody& body : longBodies) {
        if (body.agent >= m_agents || !std::isfinite(body.front) || !std::isfinite(body.back)) {
            continue;
        }
        const float radius = bodies[body.agent].radius;
        const std::size_t before = m_discs.size();
        for (const float side : {1.0F, -1.0F}) {
            const float way = std::clamp(side > 0.0F ? body.front : body.back, 0.0F, kLongest);
            const int count = discsAlong(way, radius);
            for (int i = 1; i <= count; ++i) {
                const float along = side * way * static_cast<float>(i) / static_cast<float>(count);
                m_discs.push_back({static_cast<std::uint32_t>(m_bodies.size()), along});
                m_owners.push_back(-1 - static_cast<std::int32_t>(body.agent));
                bodies.push_back(bodies[body.agent]);
            }
        }
        if (m_discs.size() > before) {
            m_owners[body.agent] = -1 - static_cast<std::int32_t>(body.agent);
            m_bodies.push_back(body);
            m_first.push_back(static_cast<std::uint32_t>(m_discs.size()));
        }
    }
    m_start.resize(m_bodies.size());
    if (m_bodies.empty()) {
        m_owners.clear();
    }
}

void LongBodies::place(std::span<Body> bodies, std::span<float> heights)
{
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        const LongBody& body = m_bodies[i];
        const Body& own = bodies[body.agent];
        m_start[i] = {own.x, own.z};
        for (std::uint32_t d = m_first[i]; d < m_first[i + 1]; ++d) {
            Body& disc = bodies[m_agents + d];
            disc = own;
            disc.x += body.headingX * m_discs[d].along;
            disc.z += body.headingZ * m_discs[d].along;
            m_discs[d].x = disc.x;
            m_discs[d].z = disc.z;
            heights[m_agents + d] = heights[body.agent];
        }
    }
}

void LongBodies::gather(std::span<Body> bodies, std::span<const float> heights,
                        const WallField& walls, float seconds) const
{
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        const LongBody& body = m_bodies[i];
        Body& own = bodies[body.agent];
        if (own.preferredSpeed == 0.0F) {
            continue; // it stands
        }
        // They go on as fast as all of them do on the whole, and are put right as far as the one is
        // that was furthest in the way.
        glm::vec2 velocity(own.velocityX, own.velocityZ);
        glm::vec2 most = glm::vec2(own.x, own.z) - m_start[i] -
                         glm::vec2(own.velocityX, own.velocityZ) * seconds;
        for (std::uint32_t d = m_first[i]; d < m_first[i + 1]; ++d) {
            const Body& disc = bodies[m_agents + d];
            const glm::vec2 own2(disc.velocityX, disc.velocityZ);
            const glm::vec2 aside =
                glm::vec2(disc.x - m_discs[d].x, disc.z - m_discs[d].z) - own2 * seconds;
            velocity += own2;
            most = glm::dot(aside, aside) > glm::dot(most, most) ? aside : most;
        }
        velocity /= static_cast<float>(1 + m_first[i + 1] - m_first[i]);
        glm::vec2 way = velocity * seconds + most;
        // What puts one disc out of a wall may put another one into it.
        const auto keepOut = [&](float x, float z) {
            float toX = x + way.x;
            float toZ = z + way.y;
            keepOutOfWalls(walls, {x, z, heights[body.agent], own.radius}, seconds, toX, toZ);
            way = glm::vec2(toX - x, toZ - z);
        };
        if (!walls.isEmpty()) {
            keepOut(m_start[i].x, m_start[i].y);
            for (std::uint32_t d = m_first[i]; d < m_first[i + 1]; ++d) {
                keepOut(m_discs[d].x, m_discs[d].z);
            }
        }
        own.x = m_start[i].x + way.x;
        own.z = m_start[i].y + way.y;
        own.velocityX = velocity.x;
        own.velocityZ = velocity.y;
    }
}

} // namespace crowd::behavior
