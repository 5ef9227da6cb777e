// SPDX-License-Identifier: MIT
#include "behavior/agents/PlaceEffects.h"

#include <algorithm>
#include <cmath>

#include <glm/vec2.hpp>

#include "model/scene/PlaceShape.h"

namespace crowd::behavior {

namespace {

constexpr float kExitMetres = 0.5F; ///< who is so near to an exit is through
constexpr float kFieldReach = 3.0F; ///< of an attractor or repeller, times its radius

} // namespace

std::vector<std::uint32_t> applyPlaceEffects(std::span<const model::Place> places,
                                             std::span<Body> bodies,
                                             std::span<const std::uint8_t> isGone)
{
    std::vector<std::uint32_t> leaving;
    std::vector<std::uint8_t> hasLeft;
    for (const model::Place& place : places) {
        const bool isField =
            place.role == model::PlaceRole::Attractor || place.role == model::PlaceRole::Repeller;
        if (!isField && place.role != model::PlaceRole::Exit) {
            continue;
        }
        hasLeft.resize(bodies.size());
        const float reach = isField ? place.radius * kFieldReach : place.radius + kExitMetres;
        const float sign = place.role == model::PlaceRole::Attractor ? 1.0F : -1.0F;
        for (std::uint32_t agent = 0; agent < bodies.size(); ++agent) {
            Body& body = bodies[agent];
            const glm::vec2 at(body.x, body.z);
            const glm::vec2 way = model::nearestOf(place, at) - at;
            const float away = std::sqrt(way.x * way.x + way.y * way.y);
            if (away > reach || body.preferredSpeed <= 0.0F || isGone[agent] != 0 ||
                hasLeft[agent] != 0) {
                continue;
            }
            if (!isField) {
                hasLeft[agent] = 1;
                leaving.push_back(agent);
                continue;
            }
            const float pull =
                sign * body.preferredSpeed * (1.0F - away / reach) / std::max(away, 0.1F);
            body.desiredX += way.x * pull;
            body.desiredZ += way.y * pull;
        }
    }
    return leaving;
}

} // namespace crowd::behavior
