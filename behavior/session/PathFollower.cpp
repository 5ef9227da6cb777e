// SPDX-License-Identifier: MIT
#include "behavior/session/PathFollower.h"

#include <algorithm>
#include <cmath>

#include "behavior/crowd/Chunks.h"
#include "model/base/Bounds.h"
#include "model/base/Random.h"

namespace crowd::behavior {

namespace {

constexpr float kArrivalMetres = 0.4F;
/// Who was pushed off his point has arrived when he is past it and not further away than this.
constexpr float kPassedMetres = 1.5F;
constexpr float kWidestPlace = 1e4F;

/// Uniform in the unit disk.
glm::vec2 shareOf(std::uint64_t seed)
{
    const float radius = std::sqrt(model::unitFloat(model::hashKeys(seed, 21)));
    const float angle = 6.2831853F * model::unitFloat(model::hashKeys(seed, 22));
    return radius * glm::vec2(std::sin(angle), std::cos(angle));
}

std::string nameOf(const model::Path& path)
{
    return "Path \"" + path.name + "\"";
}

} // namespace

std::vector<std::string> PathFollower::setPaths(std::span<const model::Place> places,
                                                std::span<const model::Path> paths)
{
    std::vector<std::string> problems;
    m_routes.clear();
    for (const model::Path& path : paths) {
        Route route{path.id, path.kind, {}};
        for (const model::PlaceId id : path.places) {
            const auto place = std::ranges::find(places, id, &model::Place::id);
            if (place == places.end()) {
                problems.push_back(nameOf(path) + " names a place that is not there any more; " +
                                   "people pass it over.");
            } else if (!model::Bounds::isPlace(place->position) || !std::isfinite(place->radius)) {
                problems.push_back("Place \"" + place->name +
                                   "\" has no position or size; people "
                                   "pass it over. Give it numbers.");
            } else {
                route.stops.push_back({{place->position.x, place->position.z},
                                       place->position.y,
                                       std::clamp(place->radius, 0.0F, kWidestPlace)});
            }
        }
        if (route.stops.empty()) {
            problems.push_back(nameOf(path) + " has no places: nobody can walk it. Add some.");
        } else {
            m_routes.push_back(std::move(route));
        }
    }
    return problems;
}

std::vector<std::string> PathFollower::assign(std::span<const Assignment> assignments,
                                              std::size_t agents)
{
    std::size_t lost = 0;
    m_walks.assign(agents, {});
    for (const Assignment& assignment : assignments) {
        const auto route = std::ranges::find(m_routes, assignment.path, &Route::id);
        if (route == m_routes.end() || assignment.agent >= agents) {
            ++lost;
            continue;
        }
        Walk& walk = m_walks[assignment.agent];
        walk.route = static_cast<std::uint32_t>(route - m_routes.begin());
        walk.share = shareOf(assignment.seed);
    }
    if (lost == 0) {
        return {};
    }
    return {"Standing still, since their paths cannot be walked: " + std::to_string(lost) +
            ". Give them another path."};
}

bool PathFollower::isWalking(std::uint32_t agent) const
{
    return m_walks[agent].route != kNoRoute && !m_walks[agent].hasArrived;
}

/// From the place reached to the next one, by the path's kind.
void PathFollower::goOn(AgentColumns& agents, std::size_t row, Walk& walk) const
{
    const Route& route = m_routes[walk.route];
    if (walk.next + 1 < route.stops.size()) {
        ++walk.next;
        return;
    }
    if (route.kind == model::PathKind::Simple || route.stops.size() == 1) {
        walk.hasArrived = true;
    } else if (route.kind == model::PathKind::Cyclic) {
        walk.next = 0;
    } else {
        const glm::vec2 start = aim(walk, route.stops[0]);
        agents.x[row] = start.x;
        agents.z[row] = start.y;
        agents.y[row] = route.stops[0].height;
        walk.next = 1;
    }
}

void PathFollower::steer(CrowdSimulation& crowd)
{
    AgentColumns& agents = crowd.columns();
    overRows(agents.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            Walk& walk = m_walks[agents.agent[row]];
            agents.desiredX[row] = 0.0F;
            agents.desiredZ[row] = 0.0F;
            if (walk.route == kNoRoute || walk.hasArrived) {
                continue;
            }
            const auto wayTo = [&] {
                const Stop& stop = m_routes[walk.route].stops[walk.next];
                return aim(walk, stop) - glm::vec2(agents.x[row], agents.z[row]);
            };
            glm::vec2 way = wayTo();
            float squared = way.x * way.x + way.y * way.y;
            const bool isPast =
                way.x * agents.velocityX[row] + way.y * agents.velocityZ[row] < 0.0F;
            const float near = isPast ? kPassedMetres : kArrivalMetres;
            if (squared < near * near) {
                goOn(agents, row, walk);
                way = wayTo();
                squared = way.x * way.x + way.y * way.y;
            }
            if (!walk.hasArrived && squared > 1e-8F) {
                const float pace = agents.preferredSpeed[row] / std::sqrt(squared);
                agents.desiredX[row] = way.x * pace;
                agents.desiredZ[row] = way.y * pace;
            }
            if (walk.hasArrived) {
                agents.preferredSpeed[row] = 0.0F; // stands from now on
            }
        }
    });
}

} // namespace crowd::behavior
