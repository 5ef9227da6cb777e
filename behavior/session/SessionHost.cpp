// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "behavior/session/Session.h"
#include "behavior/surface/WalkSurface.h"

/// What rules ask of people in a session and let them do.
namespace crowd::behavior {

glm::vec3 Session::position(std::uint32_t agent) const
{
    return m_motion.position(agent);
}

model::IndividualId Session::id(std::uint32_t agent) const
{
    return m_population.ids()[agent];
}

model::TemplateId Session::templateOf(std::uint32_t agent) const
{
    return m_population.column(model::columns::templateId)[agent];
}

std::uint32_t Session::group(std::uint32_t agent) const
{
    return m_population.column(model::columns::group)[agent];
}

bool Session::isSeated(std::uint32_t agent) const
{
    const Shown& shown = m_shown[agent];
    return shown.seat != model::kNoSeat &&
           (shown.sitting == Sitting::No || shown.sitting == Sitting::Sits);
}

bool Session::isGone(std::uint32_t agent) const
{
    return m_shown[agent].isGone;
}

model::PathId Session::pathOf(std::uint32_t agent) const
{
    return m_follower.pathOf(agent);
}

std::span<const std::uint8_t> Session::travelEvents() const
{
    return m_follower.travelEvents();
}

model::PlaceId Session::reachedPlace(std::uint32_t agent) const
{
    return m_follower.reachedPlace(agent);
}

float Session::play(std::uint32_t agent, const std::string& clip, bool isLooped)
{
    Shown& shown = m_shown[agent];
    if (shown.table >= m_templates->size()) {
        return -1.0F;
    }
    const std::vector<std::string>& names = (*m_templates)[shown.table].clipNames;
    const auto found = std::ranges::find(names, clip);
    if (found == names.end()) {
        return -1.0F;
    }
    shown.order = static_cast<int>(found - names.begin());
    shown.isOrderLooped = isLooped;
    shown.isOrderOwn = false;
    shown.orderPlace = 0.0;
    activate(agent);
    return std::max(0.1F, clipFacts(shown, shown.order)->seconds);
}

void Session::endClip(std::uint32_t agent)
{
    markDirty(agent).order = -1;
}

bool Session::follow(std::uint32_t agent, model::PathId path)
{
    if (!m_follower.hasPath(path)) {
        return false;
    }
    leaveSeat(agent);
    PathFollower::Assignment walk = walkOf(m_population, agent);
    walk.path = path;
    walk.from = m_motion.position(agent);
    walk.metresPerSecond = m_follower.pace(agent);
    return m_follower.follow(walk);
}

glm::vec3 Session::reached(const glm::vec3& from, const glm::vec3& point) const
{
    return m_surface ? m_surface->straight(from, point).value_or(point) : point;
}

float Session::wayMetres(const glm::vec3& from, const glm::vec3& to, float within) const
{
    const auto metres = m_surface ? m_surface->wayMetres(from, to, within) : std::nullopt;
    return metres.value_or(flatDistance(from, to)); // also where he is off the surface
}

void Session::sendTo(std::uint32_t agent, const glm::vec3& point, float atLeast)
{
    leaveSeat(agent);
    m_follower.sendTo(agent, point, std::min(atLeast, model::kMaxWalkingSpeed));
}

void Session::stop(std::uint32_t agent)
{
    m_follower.stop(agent);
}

void Session::goOn(std::uint32_t agent)
{
    if (m_follower.pathOf(agent) != 0) {
        leaveSeat(agent);
    }
    m_follower.goOn(agent);
}

void Session::setPace(std::uint32_t agent, float metresPerSecond)
{
    if (std::isfinite(metresPerSecond)) {
        m_follower.setPace(agent, std::clamp(metresPerSecond, 0.0F, model::kMaxWalkingSpeed));
    }
}

void Session::turnTo(std::uint32_t agent, const glm::vec3& point)
{
    const glm::vec3 way = point - m_motion.position(agent);
    if (way.x * way.x + way.z * way.z > 1e-4F) {
        Shown& shown = markDirty(agent);
        shown.facing = std::atan2(way.x, way.z);
        shown.isTurning = true;
    }
}

void Session::leave(std::uint32_t agent)
{
    leaveSeat(agent);
    activate(agent).isGone = true;
    m_motion.y[agent] = kGoneHeight;
    m_follower.stop(agent);
    m_crowd.setLevels(true);
}

float Session::speed(std::uint32_t agent) const
{
    return m_motion.speed[agent];
}

glm::vec2 Session::wantedVelocity(std::uint32_t agent) const
{
    const Body& body = m_crowd.bodies()[agent];
    return body.preferredSpeed > 0.0F ? glm::vec2(body.desiredX, body.desiredZ) : glm::vec2(0.0F);
}

void Session::appear(std::uint32_t agent, const glm::vec3& point)
{
    leaveSeat(agent);
    Shown& shown = activate(agent);
    shown.isGone = false;
    shown.isPut = true;
    shown.hasLast = false;
    shown.fadeBegin = -1.0;
    shown.gait = 0;
    m_motion.speed[agent] = 0.0F;
    m_motion.put(agent, point);
    if (m_surface) {
        m_motion.y[agent] = m_surface->height(point.x, point.z, point.y);
    }
    m_follower.stop(agent);
    m_follower.forgetWay(agent);
}

} // namespace crowd::behavior
