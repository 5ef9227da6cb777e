// SPDX-License-Identifier: MIT
#include "behavior/session/PathFollower.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/gtx/norm.hpp>

#include "behavior/crowd/Chunks.h"
#include "behavior/surface/WalkSurface.h"
#include "model/base/Bounds.h"
#include "model/base/Random.h"
#include "model/base/Segment.h"

namespace crowd::behavior {

namespace {

constexpr float kWidestPlace = 1e4F;
constexpr float kCornerMetres = 0.5F;
constexpr float kPartyEase = 0.6F;      ///< metres from the middle that nobody minds
constexpr float kPartyFarthest = 25.0F; ///< who is further away is on his own
constexpr float kPartyHaste = 0.3F;     ///< share of the speed, a metre
constexpr float kPartySlowest = 0.4F;
constexpr float kPartyFastest = 1.3F;
constexpr float kPartyPull = 0.3F;      ///< m/s sideways, a metre
constexpr float kPartyMostPull = 0.35F; ///< share of the speed
/// Who does not get nearer to his corner for so long asks for the way again.
constexpr std::uint32_t kAstraySteps = 60;

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

float squareOf(glm::vec2 v)
{
    return v.x * v.x + v.y * v.y;
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
                                        "people pass it over.",
                                    0, 0, path.id});
            } else if (!model::Bounds::isPlace(place->position) || !std::isfinite(place->radius)) {
                problems.push_back({"Place \"" + place->name +
                                        "\" has no position or size; people "
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
    touchAll();
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
    touchAll();
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
    Walk& walk = touch(assignment.agent);
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
    touchAll();
}

/// Where the groups are. Sums in the order of agents, which is the same for any number of
/// threads.
void PathFollower::gatherParties(std::span<const Body> bodies)
{
    std::ranges::fill(m_parties, Party());
    for (std::uint32_t agent = 0; agent < bodies.size(); ++agent) {
        const Walk& walk = m_walks[agent];
        if (walk.party == kNoParty || walk.hasErrand || !isWalking(agent)) {
            continue;
        }
        Party& party = m_parties[walk.party];
        party.route = party.members == 0 ? walk.route : party.route;
        if (party.route == walk.route) {
            ++party.members;
            party.middle += glm::vec2(bodies[agent].x, bodies[agent].z);
            party.pace += walk.pace;
        }
    }
    for (Party& party : m_parties) {
        const float share = 1.0F / static_cast<float>(std::max(1U, party.members));
        party.middle *= share;
        party.pace *= share;
    }
}

/// Null: he walks on his own.
const PathFollower::Party* PathFollower::partyOf(const Walk& walk) const
{
    if (walk.party == kNoParty || walk.hasErrand || m_parties[walk.party].members < 2 ||
        m_parties[walk.party].route != walk.route) {
        return nullptr;
    }
    return &m_parties[walk.party];
}

void PathFollower::keepTogether(const Party& party, const glm::vec2& at, const glm::vec2& ahead,
                                float& speed, glm::vec2& sideways)
{
    const glm::vec2 away = at - party.middle;
    if (squareOf(away) > kPartyFarthest * kPartyFarthest) {
        return;
    }
    const float lead = away.x * ahead.x + away.y * ahead.y;
    const float beyond = lead - std::clamp(lead, -kPartyEase, kPartyEase);
    speed *= std::clamp(1.0F - kPartyHaste * beyond, kPartySlowest, kPartyFastest);
    const glm::vec2 across = away - ahead * lead;
    const float distance = std::sqrt(squareOf(across));
    if (distance > kPartyEase) {
        const float pull = std::min(kPartyPull * (distance - kPartyEase), kPartyMostPull * speed);
        sideways = -across * (pull / distance);
    }
}

void PathFollower::sendTo(std::uint32_t agent, const glm::vec3& point)
{
    Walk& walk = touch(agent);
    walk.hasErrand = true;
    walk.isErrandDone = false;
    walk.isHeld = false;
    walk.errand = point;
}

void PathFollower::goOn(std::uint32_t agent)
{
    Walk& walk = touch(agent);
    walk.isHeld = false;
    walk.hasErrand = false;
    walk.isErrandDone = false;
}

void PathFollower::forgetWay(std::uint32_t agent)
{
    touch(agent).corners.clear();
    m_walks[agent].cornersFor = glm::vec2(1e30F);
}

void PathFollower::setPace(std::uint32_t agent, float metresPerSecond)
{
    touch(agent).pace = metresPerSecond;
}

void PathFollower::rearrange(std::span<const std::uint32_t> keep)
{
    std::vector<Walk> walks(keep.size());
    for (std::size_t i = 0; i < keep.size(); ++i) {
        if (keep[i] != kNobody) {
            walks[i] = std::move(m_walks[keep[i]]);
        }
    }
    m_walks = std::move(walks);
    touchAll();
}

PathFollower::Walk& PathFollower::touch(std::uint32_t agent)
{
    m_aims.course[agent] = static_cast<std::int32_t>(Course::Look);
    return m_walks[agent];
}

void PathFollower::touchAll()
{
    const std::size_t agents = m_walks.size();
    for (auto* column : {&m_aims.x, &m_aims.z, &m_aims.pace}) {
        column->resize(agents + kLanes);
    }
    m_aims.course.assign(agents + kLanes, static_cast<std::int32_t>(Course::Look));
    m_happened.assign(agents, 0);
}

void PathFollower::setSurface(std::shared_ptr<const WalkSurface> surface)
{
    m_surface = std::move(surface);
    for (Walk& walk : m_walks) {
        walk.corners.clear();
        walk.cornersFor = glm::vec2(1e30F);
    }
    touchAll();
}

bool PathFollower::isWalking(std::uint32_t agent) const
{
    const Walk& walk = m_walks[agent];
    if (walk.isHeld || walk.hasErrand) {
        return walk.hasErrand && !walk.isHeld && !walk.isErrandDone;
    }
    return walk.route != kNoRoute && !walk.hasArrived;
}

/// Some go over to another path at a place with branches.
void PathFollower::branchOff(Walk& walk) const
{
    const std::vector<Branch>& branches = m_routes[walk.route].stops[walk.next].branches;
    float total = 1.0F;
    for (const Branch& branch : branches) {
        total += branch.weight;
    }
    float drawn = total * model::unitFloat(model::hashKeys(walk.seed, 41, walk.turns)) - 1.0F;
    for (const Branch& branch : branches) {
        if (drawn >= 0.0F && drawn < branch.weight && routeOf(branch.path) != kNoRoute) {
            walk.route = routeOf(branch.path);
            walk.next = 0;
            return;
        }
        drawn -= branch.weight;
    }
}

/// From the place reached to the next one, by the path's kind.
std::uint8_t PathFollower::passStop(Body& body, float& height, Walk& walk) const
{
    walk.reached = m_routes[walk.route].stops[walk.next].place;
    ++walk.turns;
    const std::uint32_t before = walk.route;
    branchOff(walk);
    const Route& route = m_routes[walk.route];
    if (walk.route != before) {
        return ReachedPlace;
    }
    if (walk.next + 1 < route.stops.size()) {
        ++walk.next;
        return ReachedPlace;
    }
    if (route.kind == model::PathKind::Simple || route.stops.size() == 1) {
        walk.hasArrived = true;
        return ReachedPlace | EndedPath;
    }
    if (route.kind == model::PathKind::Cyclic) {
        walk.next = 0;
    } else {
        const glm::vec2 start = aim(walk, route.stops[0]);
        body.x = start.x;
        body.z = start.y;
        height = route.stops[0].height;
        walk.next = 1;
    }
    return ReachedPlace;
}

/// Vector to walk along now: to the next corner of the way around what stands between.
glm::vec2 PathFollower::wayTo(const Body& body, float height, Walk& walk, const glm::vec3& to) const
{
    const glm::vec2 at(body.x, body.z);
    const glm::vec2 aimed(to.x, to.z);
    if (!m_surface) {
        return aimed - at;
    }
    if (walk.cornersFor != aimed || walk.stepsAstray > kAstraySteps) {
        walk.corners = m_surface->way({at.x, height, at.y}, to);
        std::ranges::reverse(walk.corners); // the next one is the last
        walk.cornersFor = aimed;
        walk.stepsAstray = 0;
    }
    while (walk.corners.size() > 1 &&
           squareOf(walk.corners.back() - at) < kCornerMetres * kCornerMetres) {
        walk.corners.pop_back();
        walk.stepsAstray = 0;
    }
    const glm::vec2 way = (walk.corners.empty() ? aimed : walk.corners.back()) - at;
    const float towards = way.x * body.velocityX + way.y * body.velocityZ;
    walk.stepsAstray = towards > 0.0F ? 0 : walk.stepsAstray + 1;
    return way;
}

float PathFollower::slowness(float x, float z) const
{
    for (const SlowArea& area : m_slow) {
        if (squareOf(area.center - glm::vec2(x, z)) < area.radius * area.radius) {
            return area.share;
        }
    }
    return 1.0F;
}

glm::vec3 PathFollower::targetOf(const Walk& walk) const
{
    if (walk.hasErrand) {
        return walk.errand;
    }
    const Stop& stop = m_routes[walk.route].stops[walk.next];
    const glm::vec2 point = aim(walk, stop);
    return {point.x, stop.height, point.y};
}

void PathFollower::steerOne(std::uint32_t agent, Body& body, float& height)
{
    Walk& walk = m_walks[agent];
    body.desiredX = 0.0F;
    body.desiredZ = 0.0F;
    body.preferredSpeed = 0.0F; // stands unless there is somewhere to go
    if (!isWalking(agent)) {
        return;
    }
    const glm::vec2 at(body.x, body.z);
    const glm::vec3 target = targetOf(walk);
    const glm::vec2 left = glm::vec2(target.x, target.z) - at;
    const bool isPast = left.x * body.velocityX + left.y * body.velocityZ < 0.0F;
    const float near = isPast ? kPassedMetres : kArrivalMetres;
    // A way that ends where nothing leads on ends there.
    const bool isStuck = m_surface && walk.corners.size() == 1 &&
                         walk.corners.front() != walk.cornersFor &&
                         squareOf(walk.corners.front() - at) < kArrivalMetres * kArrivalMetres;
    if (squareOf(left) < near * near || isStuck) {
        if (walk.hasErrand) {
            walk.isErrandDone = true;
            m_happened[agent] = EndedErrand;
        } else {
            m_happened[agent] = passStop(body, height, walk);
        }
        if (!isWalking(agent)) {
            return;
        }
    }
    const glm::vec2 way = wayTo(body, height, walk, targetOf(walk));
    const float squared = squareOf(way);
    const Party* party = partyOf(walk);
    const float slow = slowness(body.x, body.z);
    float speed = (party != nullptr ? party->pace : walk.pace) * slow;
    if (squared > 1e-8F) {
        const glm::vec2 ahead = way / std::sqrt(squared);
        glm::vec2 sideways(0.0F);
        if (party != nullptr) {
            keepTogether(*party, {body.x, body.z}, ahead, speed, sideways);
        }
        body.desiredX = ahead.x * speed + sideways.x;
        body.desiredZ = ahead.y * speed + sideways.y;
    }
    body.preferredSpeed = speed;
}

/// What the next steps may do with somebody, now that he has been looked at.
void PathFollower::setAim(std::uint32_t agent)
{
    const Walk& walk = m_walks[agent];
    Course course = Course::Rests;
    m_aims.pace[agent] = 0.0F;
    if (isWalking(agent)) {
        // With others, or around what stands in the way, the aim is another one in every step.
        course = m_surface || walk.party != kNoParty ? Course::Look : Course::GoesOn;
        const glm::vec3 target = targetOf(walk);
        m_aims.x[agent] = target.x;
        m_aims.z[agent] = target.z;
        m_aims.pace[agent] = walk.pace;
    }
    m_aims.course[agent] = static_cast<std::int32_t>(course);
}

void PathFollower::steer(CrowdSimulation& crowd)
{
    const std::span<Body> bodies = crowd.bodies();
    const std::span<float> heights = crowd.heights();
    if (!m_parties.empty()) {
        gatherParties(bodies);
    }
    std::ranges::fill(m_happened, std::uint8_t{0});
    overRows(bodies.size(), [&](std::size_t begin, std::size_t end) {
        std::array<std::uint32_t, kStrideBlock + kLanes> list;
        for (std::size_t first = begin; first < end; first += kStrideBlock) {
            const std::size_t looks = steerStraightOn(
                bodies, m_aims, m_slow, first, std::min(first + kStrideBlock, end), list.data());
            for (std::size_t i = 0; i < looks; ++i) {
                steerOne(list[i], bodies[list[i]], heights[list[i]]);
                setAim(list[i]);
            }
        }
    });
}

} // namespace crowd::behavior
