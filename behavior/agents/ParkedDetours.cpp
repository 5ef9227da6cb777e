// SPDX-License-Identifier: MIT
#include "behavior/agents/ParkedDetours.h"

#include <cmath>

#include "behavior/crowd/Chunks.h"

namespace crowd::behavior {

void ParkedDetours::apply(CrowdSimulation& crowd, const PathFollower& follower,
                          const WalkSurface* surface)
{
    if (crowd.longBodies().empty()) {
        return;
    }
    const std::span<Body> bodies = crowd.bodies();
    const std::span<const float> heights = crowd.heights();
    m_parked.gather(crowd.longBodies(), bodies, heights);
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
                return surface == nullptr ||
                       surface->isStraight({from.x, height, from.y}, {to.x, height, to.y})
                           .value_or(true);
            };
            const auto agent = static_cast<std::uint32_t>(row);
            const auto aside = m_parked.around(
                {{body.x, body.z}, follower.nextAim(agent), body.radius, height}, isClear);
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
