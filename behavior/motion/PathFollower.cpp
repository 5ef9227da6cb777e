// SPDX-License-Identifier: MIT
#include "behavior/motion/PathFollower.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtx/norm.hpp>

#include "behavior/crowd/Chunks.h"
#include "behavior/crowd/ForceKernel.h"
#include "model/base/Bounds.h"
#include "model/base/Random.h"
#include "model/scene/PlaceShape.h"

namespace crowd::behavior {

namespace {

constexpr std::uint32_t kFirstCheckSteps = 20;
constexpr float kWidestLane = 6.0F; ///< metres

/// Uniform in the unit disk.
glm::vec2 shareOf(std::uint64_t seed)
{
    const float radius = std::sqrt(model::unitFloat(model::hashKeys(seed, 21)));
    const float angle = 6.2831853F * model::unitFloat(model::hashKeys(seed, 22));
    return radius * glm::vec2(std::sin(angle), std::cos(angle));
}

} // namespace

std::vector<Problem> PathFollower::setPaths(std::span<const model::Place> places,
                                            std::span<const model::Path> paths)
{
    m_slow.clear();
    for (const model::Place& place : places) {
        if (place.role == model::PlaceRole::Slow && model::Bounds::isPlace(place.position)) {
            SlowArea& area = m_slow.emplace_back();
            area.center = {place.position.x, place.position.z};
            area.radius = model::reachOf(place);
            area.share = std::clamp(place.speedShare, model::kMinSpeedShare, 1.0F);
            if (place.shape != model::PlaceShape::Round) {
                area.shape = place;
            }
        }
    }
    const PathRoutes former = m_routes;
    std::vector<Problem> problems = m_routes.set(places, paths);
    for (Walk& walk : m_walks) {
        carryOver(walk, former);
    }
    markAllDirty();
    return problems;
}

/// Goes on along its path as that is now.
void PathFollower::carryOver(Walk& walk, const PathRoutes& former) const
{
    walk.point.reset();
    if (walk.route == PathRoutes::kNone) {
        return;
    }
    const Route& before = former[walk.route];
    walk.route = m_routes.indexOf(before.id);
    if (walk.route == PathRoutes::kNone) {
        return;
    }
    const Route& route = m_routes[walk.route];
    const bool isLonger = route.stops.size() > before.stops.size();
    if (walk.hasArrived && (isLonger || route.kind != model::PathKind::Simple)) {
        walk.hasArrived = false; // there is more to walk now
        walk.next = isLonger ? static_cast<std::uint32_t>(before.stops.size()) : 0;
    }
    walk.next = std::min(walk.next, static_cast<std::uint32_t>(route.stops.size() - 1));
}

model::PathId PathFollower::pathOf(std::uint32_t agent) const
{
    const std::uint32_t route = m_walks[agent].route;
    return route == PathRoutes::kNone ? 0 : m_routes[route].id;
}

model::PlaceId PathFollower::endPlace(std::uint32_t agent) const
{
    const Walk& walk = m_walks[agent];
    return walk.hasArrived && !walk.hasErrand && walk.route != PathRoutes::kNone
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
    return {Problem{
        {QT_TRANSLATE_NOOP(
             "Messages",
             "Standing still, since their paths cannot be walked: %1. Give them another path."),
         lost}}};
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
    walk.route = m_routes.indexOf(assignment.path);
    if (walk.route == PathRoutes::kNone) {
        return false;
    }
    walk.next = m_routes[walk.route].nextStop(assignment.from);
    walk.way.setStepsToCheck(assignment.agent % kFirstCheckSteps);
    return true;
}

void PathFollower::setGroups(std::span<const std::uint32_t> groupOfAgent)
{
    const std::vector<std::uint32_t> parties = m_parties.setGroups(groupOfAgent);
    for (std::size_t agent = 0; agent < m_walks.size(); ++agent) {
        m_walks[agent].party = parties[agent];
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
    markDirty(agent).way.forget();
}

void PathFollower::setPace(std::uint32_t agent, float metresPerSecond)
{
    markDirty(agent).pace = metresPerSecond;
}

void PathFollower::rearrange(std::span<const std::uint32_t> keep)
{
    behavior::rearrange(m_walks, keep);
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
        walk.way.forget();
        walk.point.reset();
    }
    markAllDirty();
}

glm::vec2 PathFollower::nextAim(std::uint32_t agent) const
{
    const glm::vec3* corner = m_surface ? m_walks[agent].way.nextCorner() : nullptr;
    return corner == nullptr ? glm::vec2(m_aims.x[agent], m_aims.z[agent])
                             : glm::vec2(corner->x, corner->z);
}

bool PathFollower::isWalking(std::uint32_t agent) const
{
    const Walk& walk = m_walks[agent];
    if (walk.isHeld || walk.hasErrand) {
        return walk.hasErrand && !walk.isHeld && !walk.isErrandDone;
    }
    return walk.route != PathRoutes::kNone && !walk.hasArrived;
}

void PathFollower::gatherParties(std::span<const Body> bodies)
{
    m_parties.beginStep();
    for (std::uint32_t agent = 0; agent < bodies.size(); ++agent) {
        const Walk& walk = m_walks[agent];
        if (walk.party != WalkParties::kNone && !walk.hasErrand && isWalking(agent)) {
            m_parties.add(walk.party, walk.route, {bodies[agent].x, bodies[agent].z}, walk.pace);
        }
    }
    m_parties.endStep();
}

/// Null: it walks alone.
const WalkParties::Party* PathFollower::partyOf(const Walk& walk) const
{
    return walk.hasErrand ? nullptr : m_parties.find(walk.party, walk.route);
}

/// Some go over to another path at a place with branches.
void PathFollower::branchOff(Walk& walk) const
{
    const std::vector<RouteStop::Branch>& branches = m_routes[walk.route].stops[walk.next].branches;
    float total = 1.0F;
    for (const RouteStop::Branch& branch : branches) {
        total += branch.weight;
    }
    float drawn = total * model::unitFloat(model::hashKeys(walk.seed, 41, walk.turns)) - 1.0F;
    for (const RouteStop::Branch& branch : branches) {
        if (drawn >= 0.0F && drawn < branch.weight &&
            m_routes.indexOf(branch.path) != PathRoutes::kNone) {
            walk.route = m_routes.indexOf(branch.path);
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
    walk.point.reset();
    const std::uint32_t before = walk.route;
    branchOff(walk);
    const Route& route = m_routes[walk.route];
    if (walk.route != before) {
        return kReachedPlace;
    }
    if (walk.next + 1 < route.stops.size()) {
        ++walk.next;
        return kReachedPlace;
    }
    if (route.kind == model::PathKind::Simple || route.stops.size() == 1) {
        walk.hasArrived = true;
        return kReachedPlace | kEndedPath;
    }
    if (route.kind == model::PathKind::Cyclic) {
        walk.next = 0;
    } else {
        const glm::vec3 start = pointIn(walk, route.stops[0]).position;
        body.x = start.x;
        body.z = start.z;
        height = start.y;
        walk.next = 1;
    }
    return kReachedPlace;
}

/// As wide as the places that the flow comes from and goes to.
Lane PathFollower::laneOf(const Walk& walk) const
{
    if (walk.hasErrand || walk.route == PathRoutes::kNone) {
        return {};
    }
    const float radius = m_routes[walk.route].stops[walk.next].radius;
    return {walk.share, std::min(2.0F * radius, kWidestLane)};
}

/// Vector to walk along now: to the next corner of the way around what stands between.
glm::vec2 PathFollower::wayTo(const Body& body, float height, Walk& walk, const glm::vec3& to) const
{
    return m_surface ? walk.way.towards(*m_surface, body, height, to, laneOf(walk))
                     : glm::vec2(to.x, to.z) - glm::vec2(body.x, body.z);
}

float PathFollower::slowness(float x, float z) const
{
    for (const SlowArea& area : m_slow) {
        if (glm::length2(area.center - glm::vec2(x, z)) < area.radius * area.radius &&
            (!area.shape || isInShape(area, x, z))) {
            return area.share;
        }
    }
    return 1.0F;
}

/// His own point in a place: where one can get to from its middle.
PathFollower::PlacePoint PathFollower::pointIn(const Walk& walk, const RouteStop& stop) const
{
    const glm::vec2 aimed = aim(walk, stop);
    const glm::vec3 point(aimed.x, stop.height, aimed.y);
    const glm::vec3 middle(stop.position.x, stop.height, stop.position.y);
    const auto reached = m_surface ? m_surface->straight(middle, point) : std::nullopt;
    return {reached.value_or(point), reached.has_value()};
}

glm::vec3 PathFollower::targetOf(Walk& walk) const
{
    if (walk.hasErrand) {
        return walk.errand;
    }
    if (!walk.point) {
        walk.point = pointIn(walk, m_routes[walk.route].stops[walk.next]);
    }
    return walk.point->position;
}

/// How far from his aim somebody begins to come to rest; 0 where he goes on from there.
float PathFollower::brakingMetres(const Walk& walk, const Body& body) const
{
    if (!walk.hasErrand) {
        const Route& route = m_routes[walk.route];
        if (!route.isEnd(walk.next) || !route.stops[walk.next].branches.empty()) {
            return 0.0F;
        }
    }
    return glm::length2(glm::vec2(body.velocityX, body.velocityZ)) / (2.0F * kUsualBraking);
}

/// Near enough to where it is going, or past it; or its way ends where nothing leads on.
bool PathFollower::hasReached(const Walk& walk, const Body& body, float height,
                              const glm::vec3& target) const
{
    const glm::vec2 at(body.x, body.z);
    const glm::vec2 aimed(target.x, target.z);
    const glm::vec2 left = aimed - at;
    const bool isPast = left.x * body.velocityX + left.y * body.velocityZ < 0.0F;
    const float near = std::max(isPast ? kPassedMetres : kArrivalMetres, brakingMetres(walk, body));
    const bool isOnLevel =
        walk.hasErrand || !walk.point->isOnSurface || std::fabs(target.y - height) < kLevelMetres;
    return (glm::length2(left) < near * near && isOnLevel) ||
           (m_surface && walk.way.endsShort(aimed, at, kArrivalMetres));
}

void PathFollower::steerAgent(std::uint32_t agent, Body& body, float& height)
{
    Walk& walk = m_walks[agent];
    body.desiredX = 0.0F;
    body.desiredZ = 0.0F;
    body.preferredSpeed = 0.0F; // stands unless there is somewhere to go
    if (!isWalking(agent)) {
        return;
    }
    if (hasReached(walk, body, height, targetOf(walk))) {
        if (walk.hasErrand) {
            walk.isErrandDone = true;
            m_events[agent] = kEndedErrand;
        } else {
            m_events[agent] = passStop(body, height, walk);
        }
        if (!isWalking(agent)) {
            return;
        }
    }
    setVelocity(walk, body, height);
}

/// Who keep together are pushed aside together, by others that do, and would go on beside the path.
glm::vec2 PathFollower::backToPath(const Walk& walk, const Body& body, float speed) const
{
    constexpr float kPull = 0.5F;     // m/s, a metre
    constexpr float kMostPull = 0.4F; // share of the speed
    if (walk.hasErrand || walk.route == PathRoutes::kNone) {
        return glm::vec2(0.0F);
    }
    const glm::vec2 back = m_routes[walk.route].backToLeg(walk.next, {body.x, body.z});
    const float metres = glm::length(back);
    return metres > 0.0F ? back * (std::min(kPull * metres, kMostPull * speed) / metres)
                         : glm::vec2(0.0F);
}

/// The velocity that it would like.
void PathFollower::setVelocity(Walk& walk, Body& body, float height) const
{
    const glm::vec2 way = wayTo(body, height, walk, targetOf(walk));
    const float squared = glm::length2(way);
    const WalkParties::Party* party = partyOf(walk);
    const float slow = slowness(body.x, body.z);
    float speed = (party != nullptr ? party->pace : paceOf(walk)) * slow;
    if (squared > 1e-8F) {
        const glm::vec2 ahead = way / std::sqrt(squared);
        glm::vec2 sideways(0.0F);
        if (party != nullptr) {
            WalkParties::keepTogether(*party, {body.x, body.z}, ahead, speed, sideways);
            sideways += backToPath(walk, body, speed);
        }
        body.desiredX = ahead.x * speed + sideways.x;
        body.desiredZ = ahead.y * speed + sideways.y;
    }
    body.preferredSpeed = speed;
}

/// What the kernel may do with an agent from now on.
void PathFollower::setAim(std::uint32_t agent)
{
    Walk& walk = m_walks[agent];
    UpdateMode mode = UpdateMode::Rest;
    m_aims.pace[agent] = 0.0F;
    if (isWalking(agent)) {
        // With others, or around what stands in the way, the aim is another one in every step.
        mode =
            m_surface || walk.party != WalkParties::kNone ? UpdateMode::Full : UpdateMode::Continue;
        const glm::vec3 target = targetOf(walk);
        m_aims.x[agent] = target.x;
        m_aims.z[agent] = target.z;
        m_aims.pace[agent] = paceOf(walk);
    }
    m_aims.mode[agent] = static_cast<std::int32_t>(mode);
}

void PathFollower::steer(CrowdSimulation& crowd)
{
    const std::span<Body> bodies = crowd.bodies();
    const std::span<float> heights = crowd.heights();
    if (!m_parties.isEmpty()) {
        gatherParties(bodies);
    }
    std::ranges::fill(m_events, std::uint8_t{0});
    overRows(bodies.size(), [&](std::size_t begin, std::size_t end) {
        std::array<std::uint32_t, kStrideBlock + kLanes> list;
        for (std::size_t first = begin; first < end; first += kStrideBlock) {
            const std::size_t updates = steerStraightOn(
                bodies, m_aims, m_slow, first, std::min(first + kStrideBlock, end), list.data());
            for (std::size_t i = 0; i < updates; ++i) {
                steerAgent(list[i], bodies[list[i]], heights[list[i]]);
                setAim(list[i]);
            }
        }
    });
}

} // namespace crowd::behavior
