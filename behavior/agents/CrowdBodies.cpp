// SPDX-License-Identifier: MIT
#include "behavior/agents/CrowdBodies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "behavior/crowd/ForceKernel.h"

namespace crowd::behavior {

namespace {

constexpr int kObstacleSides = 12;
constexpr float kBelowObstacle = 1.0F; ///< metres that its walls reach down
constexpr float kAboveObstacle = 2.0F;

} // namespace

void setBodies(CrowdSimulation& crowd, const model::Population& people, const AgentColumns& agents,
               const TemplateTables& templates, bool hasSurface)
{
    const auto girths = people.column(model::columns::girth);
    const MotionState& motion = agents.motion;
    std::vector<AgentState> bodies(people.size());
    std::vector<LongBody> longBodies;
    bool hasLevels = hasSurface;
    for (std::size_t row = 0; row < bodies.size(); ++row) {
        bodies[row].position = {motion.x[row], motion.z[row]};
        bodies[row].groundHeight = motion.y[row];
        const model::Footprint& footprint = templates.footprint(agents.table[row]);
        const float girth = std::clamp(girths[row], 0.05F, 20.0F);
        bodies[row].radius = footprint.radius * girth;
        if (footprint.front > 0.0F || footprint.back > 0.0F) {
            longBodies.push_back(
                {static_cast<std::uint32_t>(row), footprint.front * girth, footprint.back * girth});
        }
        bodies[row].preferredSpeed = 0.0F; // until it is steered
        bodies[row].velocity = motion.speed[row] * glm::vec2(std::sin(motion.heading[row]),
                                                             std::cos(motion.heading[row]));
        hasLevels = hasLevels || std::fabs(motion.y[row] - motion.y.front()) > kLevelMetres;
    }
    crowd.setLevels(hasLevels);
    crowd.setAgents(bodies, longBodies);
    turnLongBodies(crowd, motion);
}

void turnLongBodies(CrowdSimulation& crowd, const MotionState& motion)
{
    for (LongBody& body : crowd.longBodies()) {
        const float heading = motion.heading[body.agent];
        body.headingX = std::sin(heading);
        body.headingZ = std::cos(heading);
    }
}

void addObstacleWalls(std::span<const model::Place> places, std::vector<Wall>& walls)
{
    for (const model::Place& place : places) {
        for (int side = 0; side < kObstacleSides && place.role == model::PlaceRole::Obstacle;
             ++side) {
            const auto corner = [&](int index) {
                const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(index) /
                                    static_cast<float>(kObstacleSides);
                return glm::vec2(place.position.x, place.position.z) +
                       place.radius * glm::vec2(std::sin(angle), std::cos(angle));
            };
            walls.push_back({corner(side), corner(side + 1), place.position.y - kBelowObstacle,
                             place.position.y + kAboveObstacle, true});
        }
    }
}

} // namespace crowd::behavior
