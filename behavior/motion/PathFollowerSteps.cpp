// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtx/norm.hpp>

#include "behavior/crowd/Chunks.h"
#include "behavior/crowd/ForceKernel.h"
#include "behavior/motion/PathFollower.h"
#include "behavior/surface/WalkSurface.h"
#include "model/base/Random.h"

/// What a step does with those who follow paths.
namespace crowd::behavior {

namespace {

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
constexpr std::uint32_t kCheckSteps = 20;
constexpr float kPassedCorner = 4.0F; ///< metres: further away nobody has passed it
constexpr float kWidestLane = 6.0F;

} // namespace

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
    if (glm::length2(away) > kPartyFarthest * kPartyFarthest) {
        return;
    }
    const float lead = away.x * ahead.x + away.y * ahead.y;
    const float beyond = lead - std::clamp(lead, -kPartyEase, kPartyEase);
    speed *= std::clamp(1.0F - kPartyHaste * beyond, kPartySlowest, kPartyFastest);
    const glm::vec2 across = away - ahead * lead;
    const float distance = std::sqrt(glm::length2(across));
    if (distance > kPartyEase) {
        const float pull = std::min(kPartyPull * (distance - kPartyEase), kPartyMostPull * speed);
        sideways = -across * (pull / distance);
    }
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
    if (walk.hasErrand || walk.route == kNoRoute) {
        return {};
    }
    const float radius = m_routes[walk.route].stops[walk.next].radius;
    return {walk.share, std::min(2.0F * radius, kWidestLane)};
}

/// Corners that lie behind somebody: he has come to them, or past them further out in the bend.
void PathFollower::passCorners(const glm::vec3& at, Walk& walk) const
{
    const auto flat = [](const glm::vec3& point) { return glm::vec2(point.x, point.z); };
    const auto unit = [](const glm::vec2& way) {
        const float squared = glm::length2(way);
        return squared > 1e-8F ? way / std::sqrt(squared) : glm::vec2(0.0F);
    };
    while (walk.corners.size() > 1) {
        const glm::vec2 corner = flat(walk.corners.back());
        const glm::vec2 away = flat(at) - corner;
        const glm::vec2 next = flat(walk.corners[walk.corners.size() - 2]);
        const glm::vec2 through = unit(corner - walk.cornerBefore) + unit(next - corner);
        const bool isPast =
            glm::dot(away, through) > 0.0F && glm::length2(away) < kPassedCorner * kPassedCorner;
        if (glm::length2(away) >= kCornerMetres * kCornerMetres && !isPast) {
            return;
        }
        walk.cornerBefore = corner;
        walk.corners.pop_back();
        walk.stepsAstray = 0;
    }
}

/// Now and then: others may have pushed him off his way, so far that something is between, or to
/// where the next corner is on another level.
void PathFollower::checkWay(const glm::vec3& at, Walk& walk) const
{
    if (walk.stepsToCheck > 0) {
        --walk.stepsToCheck;
        return;
    }
    walk.stepsToCheck = kCheckSteps;
    if (!walk.corners.empty() && !m_surface->isStraight(at, walk.corners.back()).value_or(true)) {
        walk.cornersFor = glm::vec2(1e30F); // looked for anew
    }
}

/// Vector to walk along now: to the next corner of the way around what stands between.
glm::vec2 PathFollower::wayTo(const Body& body, float height, Walk& walk, const glm::vec3& to) const
{
    const glm::vec3 at(body.x, height, body.z);
    const glm::vec2 aimed(to.x, to.z);
    if (!m_surface) {
        return aimed - glm::vec2(at.x, at.z);
    }
    passCorners(at, walk);
    checkWay(at, walk);
    if (walk.cornersFor != aimed || walk.stepsAstray > kAstraySteps) {
        walk.corners = m_surface->way(at, to, laneOf(walk));
        std::ranges::reverse(walk.corners); // the next one is the last
        walk.cornersFor = aimed;
        walk.cornerBefore = {at.x, at.z};
        walk.stepsAstray = 0;
        passCorners(at, walk);
    }
    const glm::vec2 next =
        walk.corners.empty() ? aimed : glm::vec2(walk.corners.back().x, walk.corners.back().z);
    const glm::vec2 way = next - glm::vec2(at.x, at.z);
    const float towards = way.x * body.velocityX + way.y * body.velocityZ;
    walk.stepsAstray = towards > 0.0F ? 0 : walk.stepsAstray + 1;
    return way;
}

float PathFollower::slowness(float x, float z) const
{
    for (const SlowArea& area : m_slow) {
        if (glm::length2(area.center - glm::vec2(x, z)) < area.radius * area.radius) {
            return area.share;
        }
    }
    return 1.0F;
}

/// His own point in a place: where one can get to from its middle.
PathFollower::PlacePoint PathFollower::pointIn(const Walk& walk, const Stop& stop) const
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
        const bool isLast = walk.next + 1 == route.stops.size() &&
                            (route.kind == model::PathKind::Simple || route.stops.size() == 1);
        if (!isLast || !route.stops[walk.next].branches.empty()) {
            return 0.0F;
        }
    }
    return glm::length2(glm::vec2(body.velocityX, body.velocityZ)) / (2.0F * kUsualBraking);
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
    const float near = std::max(isPast ? kPassedMetres : kArrivalMetres, brakingMetres(walk, body));
    // A way that ends where nothing leads on ends there; that to an aim he had before says nothing.
    const glm::vec2 aimed(target.x, target.z);
    const glm::vec2 end = walk.corners.size() == 1
                              ? glm::vec2(walk.corners.front().x, walk.corners.front().z)
                              : walk.cornersFor;
    const bool isStuck = m_surface && walk.cornersFor == aimed && end != aimed &&
                         glm::length2(end - at) < kArrivalMetres * kArrivalMetres;
    const bool isOnLevel =
        walk.hasErrand || !walk.point->isOnSurface || std::fabs(target.y - height) < kLevelMetres;
    if ((glm::length2(left) < near * near && isOnLevel) || isStuck) {
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
    const glm::vec2 way = wayTo(body, height, walk, targetOf(walk));
    const float squared = glm::length2(way);
    const Party* party = partyOf(walk);
    const float slow = slowness(body.x, body.z);
    float speed = (party != nullptr ? party->pace : paceOf(walk)) * slow;
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
    Walk& walk = m_walks[agent];
    UpdateMode mode = UpdateMode::Rest;
    m_aims.pace[agent] = 0.0F;
    if (isWalking(agent)) {
        // With others, or around what stands in the way, the aim is another one in every step.
        mode = m_surface || walk.party != kNoParty ? UpdateMode::Full : UpdateMode::Continue;
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
    if (!m_parties.empty()) {
        gatherParties(bodies);
    }
    std::ranges::fill(m_events, std::uint8_t{0});
    overRows(bodies.size(), [&](std::size_t begin, std::size_t end) {
        std::array<std::uint32_t, kStrideBlock + kLanes> list;
        for (std::size_t first = begin; first < end; first += kStrideBlock) {
            const std::size_t updates = steerStraightOn(
                bodies, m_aims, m_slow, first, std::min(first + kStrideBlock, end), list.data());
            for (std::size_t i = 0; i < updates; ++i) {
                steerOne(list[i], bodies[list[i]], heights[list[i]]);
                setAim(list[i]);
            }
        }
    });
}

} // namespace crowd::behavior
