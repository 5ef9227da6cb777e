// SPDX-License-Identifier: MIT
#include <cmath>

#include "behavior/crowd/Chunks.h"
#include "behavior/session/Session.h"
#include "behavior/surface/WalkSurface.h"

/// How people get around what stands in their way and is no part of the stage.
namespace crowd::behavior {

void Session::goAroundParked()
{
    if (m_crowd.longBodies().empty()) {
        return;
    }
    const std::span<Body> bodies = m_crowd.bodies();
    const std::span<const float> heights = m_crowd.heights();
    m_parked.gather(m_crowd.longBodies(), bodies, heights);
    if (m_parked.isEmpty()) {
        return;
    }
    overRows(bodies.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            Body& body = bodies[row];
            if (body.preferredSpeed <= 0.0F) {
                continue;
            }
            const float height = heights[row];
            const auto isClear = [&](const glm::vec2& from, const glm::vec2& to) {
                return !m_surface ||
                       m_surface->isStraight({from.x, height, from.y}, {to.x, height, to.y})
                           .value_or(true);
            };
            const auto agent = static_cast<std::uint32_t>(row);
            const auto aside = m_parked.around(
                {{body.x, body.z}, m_follower.nextAim(agent), body.radius, height}, isClear);
            if (aside) {
                const float speed =
                    std::sqrt(body.desiredX * body.desiredX + body.desiredZ * body.desiredZ);
                body.desiredX = aside->x * speed;
                body.desiredZ = aside->y * speed;
            }
        }
    });
}

} // namespace crowd::behavior
