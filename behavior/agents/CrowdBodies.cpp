// SPDX-License-Identifier: MIT
#include "behavior/agents/CrowdBodies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "behavior/crowd/ForceKernel.h"
#include "model/scene/PlaceShape.h"

namespace crowd::behavior {

namespace {

constexpr int kObstacleSides = 12;
constexpr float kBelowObstacle = 1.0F; ///< metres that its walls reach down
constexpr float kAboveObstacle = 2.0F;

void addDisc(const model::Place& place, std::vector<Wall>& walls)
{
    for (int side = 0; side < kObstacleSides; ++side) {
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

/// Over the ground from the one to the other, as high as an obstacle.
Wall wallBetween(const glm::vec3& from, const glm::vec3& to)
{
    return {{from.x, from.z},
            {to.x, to.z},
            std::min(from.y, to.y) - kBelowObstacle,
            std::max(from.y, to.y) + kAboveObstacle,
            true};
}

/// A box around each of its pieces, so much longer as it is wide: where pieces meet no gap is left.
void addLine(const model::Place& place, std::vector<Wall>& walls)
{
    const std::vector<glm::vec3> corners = model::cornersOf(place);
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const glm::vec2 way(corners[i + 1].x - corners[i].x, corners[i + 1].z - corners[i].z);
        const float metres = glm::length(way);
        if (metres <= 0.0F) {
            continue;
        }
        const glm::vec3 along = glm::vec3(way.x, 0.0F, way.y) * (place.radius / metres);
        const glm::vec3 aside(along.z, 0.0F, -along.x);
        const glm::vec3 from = corners[i] - along;
        const glm::vec3 to = corners[i + 1] + along;
        walls.push_back(wallBetween(from - aside, to - aside));
        walls.push_back(wallBetween(to - aside, to + aside));
        walls.push_back(wallBetween(to + aside, from + aside));
        walls.push_back(wallBetween(from + aside, from - aside));
    }
}

/// Twice the area that the corners go around, in the sense of the walls of a disc above zero.
float turnOf(const std::vector<glm::vec3>& corners)
{
    float turn = 0.0F;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::vec3 a = corners[i] - corners.front();
        const glm::vec3 b = corners[(i + 1) % corners.size()] - corners.front();
        turn += a.z * b.x - a.x * b.z;
    }
    return turn;
}

void addArea(const model::Place& place, std::vector<Wall>& walls)
{
    std::vector<glm::vec3> corners = model::cornersOf(place);
    if (!corners.empty() && turnOf(corners) < 0.0F) {
        std::ranges::reverse(corners);
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        walls.push_back(wallBetween(corners[i], corners[(i + 1) % corners.size()]));
    }
}

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
        if (place.role != model::PlaceRole::Obstacle) {
            continue;
        }
        switch (place.shape) {
        case model::PlaceShape::Round:
            addDisc(place, walls);
            break;
        case model::PlaceShape::Line:
            addLine(place, walls);
            break;
        case model::PlaceShape::Area:
            addArea(place, walls);
            break;
        }
    }
}

} // namespace crowd::behavior
