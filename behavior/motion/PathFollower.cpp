// SPDX-License-Identifier: MIT
#include "behavior/motion/PathFollower.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtx/norm.hpp>

#include "model/base/Bounds.h"
#include "model/base/Random.h"
#include "model/base/Segment.h"

namespace crowd::behavior {

namespace {

constexpr std::uint32_t kFirstCheckSteps = 20;

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

std::vector<Problem> PathFollower::setPaths(std::span<const model::Place> places,
                                            std::span<const model::Path> paths)
{
    std::vector<Problem> problems;
    const std::vector<Route> former = std::move(m_routes);
    m_routes.clear();
    m_slow.clear();
    for (const model::Place& place : places) {
        if (place.role == model::PlaceRole::Slow && model::Bounds::isPlace(place.position)) {
            m_slow.push_back({{place.position.x, place.position.z},
                              place.radius,
                              std::clamp(place.speedShare, model::kMinSpeedShare, 1.0F)});
        }
    }
    for (const model::Path& path : paths) {
        Route route{path.id, path.kind, {}};
        for (const model::PlaceId id : path.places) {
            const auto place = std::ranges::find(places, id, &model::Place::id);
            if (place == places.end()) {
                problems.push_back({nameOf(path) + " names a place that is not there any more; " +
                                        "characters pass it over.",
                                    0, 0, path.id});
            } else if (!model::Bounds::isPlace(place->position) || !std::isfinite(place->radius)) {
                problems.push_back({"Place \"" + place->name +
                                        "\" has no position or size; characters "
                                        "pass it over. Give it numbers.",
                                    0, place->id, path.id});
            } else {
                Stop stop{id,
                          {place->position.x, place->position.z},
                          place->position.y,
                          std::clamp(place->radius, 0.0F, kWidestPlace)};
                for (const model::PathBranch& branch : path.branches) {
                    if (branch.place == id) {
                        stop.branches.push_back({branch.path, std::max(branch.weight, 0.0F)});
                    }
                }
                route.stops.push_back(std::move(stop));
            }
        }
        if (route.stops.empty()) {
            problems.push_back(
                {nameOf(path) + " has no places: nobody can walk it. Add some.", 0, 0, path.id});
        } else {
            m_routes.push_back(std::move(route));
        }
    }
    for (Walk& walk : m_walks) {
        walk.point.reset();
        if (walk.route == kNoRoute) {
            continue;
        }
        const std::size_t formerStops = former[walk.route].stops.size();
        walk.route = routeOf(former[walk.route].id);
        if (walk.route == kNoRoute) {
            continue;
        }
        const Route& route = m_routes[walk.route];
        const bool isLonger = route.stops.size() > formerStops;
        if (walk.hasArrived && (isLonger || route.kind != model::PathKind::Simple)) {
            walk.hasArrived = false; // there is more to walk now
            walk.next = isLonger ? static_cast<std::uint32_t>(formerStops) : 0;
        }
        walk.next = std::min(walk.next, static_cast<std::uint32_t>(route.stops.size() - 1));
    }
    markAllDirty();
    return problems;
}

std::uint32_t PathFollower::routeOf(model::PathId path) const
{
    const auto route = std::ranges::find(m_routes, path, &Route::id);
    return route == m_routes.end() ? kNoRoute
                                   : static_cast<std::uint32_t>(route - m_routes.begin());
}

model::PathId PathFollower::pathOf(std::uint32_t agent) const
{
    const std::uint32_t route = m_walks[agent].route;
    return route == kNoRoute ? 0 : m_routes[route].id;
}

model::PlaceId PathFollower::endPlace(std::uint32_t agent) const
{
    const Walk& walk = m_walks[agent];
    return walk.hasArrived && !walk.hasErrand && walk.route != kNoRoute
               ? m_routes[walk.route].stops.back().place
               : 0;
}

std::vector<Problem> PathFollower::assign(std::span<const Assignment> assignments,
                                          std::size_t agents)
{
    std::size_t lost = 0;
    m_walks.assign(agents, {});
    markAllDirty();
    for (const Assignment& assignment : assignments) {
        lost += assignment.agent < agents && follow(assignment) ? 0 : 1;
    }
    if (lost == 0) {
        return {};
    }
    return {{"Standing still, since their paths cannot be walked: " + std::to_string(lost) +
             ". Give them another path."}};
}

std::uint32_t PathFollower::nextStop(const Route& route, const glm::vec3& from)
{
    const auto count = static_cast<std::uint32_t>(route.stops.size());
    const std::uint32_t legs =
        route.kind == model::PathKind::Cyclic && count > 2 ? count : count - 1;
    const auto point = [&](std::uint32_t stop) {
        const Stop& at = route.stops[stop % count];
        return glm::vec3(at.position.x, at.height, at.position.y);
    };
    std::uint32_t next = 0;
    float least = std::numeric_limits<float>::infinity();
    for (std::uint32_t leg = 0; leg < legs; ++leg) {
        const glm::vec3 begin = point(leg);
        const glm::vec3 end = point(leg + 1);
        const float share = model::nearestShare(from, begin, end);
        const float distance2 = glm::distance2(from, glm::mix(begin, end, share));
        if (distance2 < least) {
            least = distance2;
            next = share > 0.0F ? (leg + 1) % count : leg;
        }
    }
    return next;
}

bool PathFollower::follow(const Assignment& assignment)
{
    Walk& walk = markDirty(assignment.agent);
    const std::uint32_t turns = walk.turns;
    const std::uint32_t party = walk.party;
    walk = {};
    walk.turns = turns;
    walk.party = party;
    walk.beside = assignment.spread * shareOf(assignment.ownSeed);
    walk.seed = assignment.seed;
    walk.share = shareOf(assignment.seed);
    walk.pace = assignment.metresPerSecond;
    walk.route = routeOf(assignment.path);
    if (walk.route == kNoRoute) {
        return false;
    }
    walk.next = nextStop(m_routes[walk.route], assignment.from);
    walk.stepsToCheck = assignment.agent % kFirstCheckSteps; // not all in the same step
    return true;
}

void PathFollower::setGroups(std::span<const std::uint32_t> groupOfAgent)
{
    std::vector<std::uint32_t> groups(groupOfAgent.begin(), groupOfAgent.end());
    std::ranges::sort(groups);
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    std::erase(groups, 0U);
    m_parties.assign(groups.size(), {});
    for (std::size_t agent = 0; agent < m_walks.size(); ++agent) {
        const std::uint32_t group = groupOfAgent[agent];
        const auto found = std::ranges::lower_bound(groups, group);
        m_walks[agent].party =
            group == 0 ? kNoParty : static_cast<std::uint32_t>(found - groups.begin());
    }
    markAllDirty();
}

void PathFollower::sendTo(std::uint32_t agent, const glm::vec3& point, float atLeast)
{
    Walk& walk = markDirty(agent);
    walk.hasErrand = true;
    walk.isErrandDone = false;
    walk.isHeld = false;
    walk.errand = point;
    walk.errandPace = atLeast;
}

void PathFollower::goOn(std::uint32_t agent)
{
    Walk& walk = markDirty(agent);
    walk.isHeld = false;
    walk.hasErrand = false;
    walk.isErrandDone = false;
}

void PathFollower::forgetWay(std::uint32_t agent)
{
    markDirty(agent).corners.clear();
    m_walks[agent].cornersFor = glm::vec2(1e30F);
}

void PathFollower::setPace(std::uint32_t agent, float metresPerSecond)
{
    markDirty(agent).pace = metresPerSecond;
}

void PathFollower::rearrange(std::span<const std::uint32_t> keep)
{
    std::vector<Walk> walks(keep.size());
    for (std::size_t i = 0; i < keep.size(); ++i) {
        if (keep[i] != kNoAgent) {
            walks[i] = std::move(m_walks[keep[i]]);
        }
    }
    m_walks = std::move(walks);
    markAllDirty();
}

PathFollower::Walk& PathFollower::markDirty(std::uint32_t agent)
{
    m_aims.mode[agent] = static_cast<std::int32_t>(UpdateMode::Full);
    return m_walks[agent];
}

void PathFollower::markAllDirty()
{
    const std::size_t agents = m_walks.size();
    for (auto* column : {&m_aims.x, &m_aims.z, &m_aims.pace}) {
        column->resize(agents + kLanes);
    }
    m_aims.mode.assign(agents + kLanes, static_cast<std::int32_t>(UpdateMode::Full));
    m_events.assign(agents, 0);
}

void PathFollower::setSurface(std::shared_ptr<const WalkSurface> surface)
{
    m_surface = std::move(surface);
    for (Walk& walk : m_walks) {
        walk.corners.clear();
        walk.cornersFor = glm::vec2(1e30F);
        walk.point.reset();
    }
    markAllDirty();
}

glm::vec2 PathFollower::nextAim(std::uint32_t agent) const
{
    const std::vector<glm::vec3>& corners = m_walks[agent].corners;
    return !m_surface || corners.empty() ? glm::vec2(m_aims.x[agent], m_aims.z[agent])
                                         : glm::vec2(corners.back().x, corners.back().z);
}

bool PathFollower::isWalking(std::uint32_t agent) const
{
    const Walk& walk = m_walks[agent];
    if (walk.isHeld || walk.hasErrand) {
        return walk.hasErrand && !walk.isHeld && !walk.isErrandDone;
    }
    return walk.route != kNoRoute && !walk.hasArrived;
}

} // namespace crowd::behavior
