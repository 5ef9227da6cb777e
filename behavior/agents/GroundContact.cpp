// SPDX-License-Identifier: MIT
#include "behavior/agents/GroundContact.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crowd::behavior {

namespace {

constexpr float kLiftSeconds = 0.15F; ///< so long before a step up feet are lifted
constexpr float kSameHeight = 0.001F; ///< metres

} // namespace

void GroundContact::setSurface(std::shared_ptr<const WalkSurface> surface)
{
    m_surface = std::move(surface);
    reset(m_agents.size());
}

/// The height of the ground where its feet will be: before a step up it lifts them, down a step it
/// goes once it is over it.
float GroundContact::heightAhead(const Body& body, float height, float surfaceHeight) const
{
    const float ahead = m_surface->underfoot(body.x + body.velocityX * kLiftSeconds,
                                             body.z + body.velocityZ * kLiftSeconds, surfaceHeight);
    return std::fabs(ahead - height) < kSameHeight
               ? ahead
               : std::max(ahead, m_surface->underfoot(body.x, body.z, surfaceHeight));
}

void GroundContact::update(std::uint32_t agent)
{
    State& state = m_states[agent];
    Body& body = m_crowd.bodies()[agent];
    if (m_agents.isGone[agent] != 0 || m_agents.isFixed(agent)) {
        state = {};
        return;
    }
    const bool isWalking = body.preferredSpeed != 0.0F;
    if (!isWalking && state.isSettled) {
        return;
    }
    state.isSettled = !isWalking;
    float& height = m_crowd.heights()[agent];
    if (!m_surface->follow(state.footing, {body.x, height, body.z})) {
        return;
    }
    const glm::vec3& point = state.footing.point;
    const glm::vec2 off(body.x - point.x, body.z - point.z);
    const float away = std::sqrt(off.x * off.x + off.y * off.y);
    if (away > m_surface->margin()) {
        // The crowd has pushed it over an edge.
        body.x = point.x + off.x * (m_surface->margin() / away);
        body.z = point.z + off.y * (m_surface->margin() / away);
    }
    const float ground = heightAhead(body, height, point.y);
    const float left = ground - height;
    state.isSettled = !isWalking && std::fabs(left) < kSameHeight;
    height = state.isSettled ? ground : height + left * m_rampShare;
}

} // namespace crowd::behavior
