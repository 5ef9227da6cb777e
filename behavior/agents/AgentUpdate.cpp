// SPDX-License-Identifier: MIT
#include "behavior/agents/AgentUpdate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "behavior/agents/Turning.h"
#include "behavior/crowd/Chunks.h"
#include "behavior/motion/StrideKernel.h"
#include "model/base/Bounds.h"

namespace crowd::behavior {

namespace {

constexpr float kSpeedSmoothing = 0.15F; ///< in 1/30 s
constexpr float kTurnsAbove = 0.15F;     ///< m/s: below, nobody turns to where it is pushed
constexpr float kMovesAbove = 0.02F;     ///< m/s
constexpr float kFastestStride = 12.0F;  ///< m/s: faster is no walk but a jump

float speedOf(const Body& body)
{
    return std::sqrt(body.velocityX * body.velocityX + body.velocityZ * body.velocityZ);
}

/// See Body::preferredSpeed.
void brakeBody(Body& body, float metresPerSecond2)
{
    if (metresPerSecond2 > 0.0F) {
        body.preferredSpeed = -metresPerSecond2;
    }
}

} // namespace

AgentUpdate::AgentUpdate(const model::Population& people, const SessionClock& clock,
                         AgentColumns& agents, CrowdSimulation& crowd, GroundContact& ground,
                         ClipAnimation& animation)
    : m_people(people), m_clock(clock), m_agents(agents), m_crowd(crowd), m_ground(ground),
      m_animation(animation), m_smoothing(clock.shareInStep(kSpeedSmoothing))
{
}

void AgentUpdate::brake()
{
    const std::span<Body> bodies = m_crowd.bodies();
    overRows(bodies.size(), [this, bodies](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            Body& body = bodies[row];
            if (body.preferredSpeed != 0.0F) {
                continue;
            }
            const float speed = speedOf(body);
            const bool isBound = m_agents.isGone[row] != 0 || m_agents.isPut[row] != 0 ||
                                 m_agents.seatPhase[row] != SeatPhase::None;
            if (speed >= kMovesAbove && !isBound) {
                brakeBody(body, m_animation.braking(static_cast<std::uint32_t>(row), speed));
            }
        }
    });
}

void AgentUpdate::updateAll()
{
    overRows(m_agents.size(), [this](std::size_t begin, std::size_t end) {
        for (std::size_t first = begin; first < end; first += kStrideBlock) {
            updateBlock(first, std::min(first + kStrideBlock, end));
        }
    });
}

void AgentUpdate::updateBlock(std::size_t begin, std::size_t end)
{
    for (std::size_t agent = begin; agent < end && m_ground.hasSurface(); ++agent) {
        m_ground.update(static_cast<std::uint32_t>(agent));
    }
    const std::span<const Body> bodies = m_crowd.bodies();
    const StrideParameters parameters{
        m_clock.stepSeconds, m_smoothing, kTurnRadiansPerSecond * m_clock.stepSeconds,
        kTurnsAbove,         kMovesAbove, kFastestStride};
    std::array<std::uint32_t, kStrideBlock + kLanes> list;
    const std::size_t updates =
        strideOn(bodies, m_crowd.heights(), m_agents.motion, parameters, begin, end, list.data());
    for (std::size_t i = 0; i < updates; ++i) {
        updateAgent(list[i]);
    }
}

/// Moves the bodies of agents that are where they are, whatever the crowd says. False: it has left
/// the scene, and there is nothing more to do.
bool AgentUpdate::placeBody(std::uint32_t agent)
{
    Body& body = m_crowd.bodies()[agent];
    float& height = m_crowd.heights()[agent];
    if (m_agents.isGone[agent] != 0) {
        // Out of everybody's way, spread as they were at the beginning.
        const glm::vec3 start = m_people.column(model::columns::position)[agent];
        const bool isSomewhere = model::Bounds::isPlace(start);
        body.x = isSomewhere ? start.x : 0.0F;
        body.z = isSomewhere ? start.z : 0.0F;
        height = kGoneHeight;
        return false;
    }
    if (m_agents.isFixed(agent)) {
        body.x = m_agents.motion.x[agent];
        body.z = m_agents.motion.z[agent];
        height = m_agents.motion.y[agent];
        body.velocityX = 0.0F;
        body.velocityZ = 0.0F;
        m_agents.isPut[agent] = 0;
    }
    return true;
}

void AgentUpdate::updateAgent(std::uint32_t agent)
{
    if (!placeBody(agent)) {
        return;
    }
    MotionState& motion = m_agents.motion;
    const Body& body = m_crowd.bodies()[agent];
    const float speed = speedOf(body);
    if (speed > kMovesAbove || m_animation.isPlaying(agent) || m_agents.isTurning[agent] != 0 ||
        body.preferredSpeed > 0.0F) {
        m_agents.activate(agent);
    }
    if (!m_agents.isActive(agent)) {
        motion.mode[agent] = static_cast<std::int32_t>(UpdateMode::Rest);
        return;
    }
    const glm::vec2 way(body.x - motion.x[agent], body.z - motion.z[agent]);
    motion.put(agent, {body.x, m_crowd.heights()[agent], body.z});
    if (m_agents.seatPhase[agent] != SeatPhase::Settling) {
        motion.speed[agent] += (speed - motion.speed[agent]) * m_smoothing;
    }
    turn(agent, speed);
    const float heading = motion.heading[agent];
    const float ahead =
        (way.x * std::sin(heading) + way.y * std::cos(heading)) / m_clock.stepSeconds;
    motion.stride[agent] = ahead < kFastestStride ? std::max(ahead, 0.0F) : 0.0F;
    m_animation.advanceClip(agent);
    m_animation.updateGait(agent, speed, body.preferredSpeed > 0.0F);
    m_animation.updateShownClip(agent);
    m_animation.setUpdateMode(agent);
}

/// To where it goes; while it stands, to where it was told to.
void AgentUpdate::turn(std::uint32_t agent, float metresPerSecond)
{
    float& heading = m_agents.motion.heading[agent];
    const float most = kTurnRadiansPerSecond * m_clock.stepSeconds;
    if (metresPerSecond > kTurnsAbove) {
        const Body& body = m_crowd.bodies()[agent];
        heading = turnedTowards(heading, std::atan2(body.velocityX, body.velocityZ), most);
        m_agents.isTurning[agent] = 0;
    } else if (m_agents.isTurning[agent] != 0) {
        heading = turnedTowards(heading, m_agents.facing[agent], most);
    }
}

} // namespace crowd::behavior
