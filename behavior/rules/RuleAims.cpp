// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "behavior/rules/RuleEngine.h"
#include "model/base/Random.h"

/// What people do about somebody or something: run from it, turn to it, go there, follow, look.
namespace crowd::behavior {

namespace {

constexpr float kAllRound = 6.2831853F;
constexpr double kSecondsBetweenLooks = 0.2; ///< at where the other one is now
constexpr float kLeastDistance = 0.6F;       ///< metres between two who stand together
constexpr float kAimsAnew = 0.3F;            ///< metres that the other one has gone on
constexpr float kSetsOutAgain = 0.5F;        ///< metres beyond the distance that is kept
constexpr float kBeside = 0.35F;             ///< metres: not all to the same point
constexpr float kFarBehind = 4.0F;           ///< metres at which one hurries most
constexpr float kHaste = 0.4F;               ///< share of the other one's speed on top of it
constexpr double kPatienceSeconds = 5.0;     ///< without getting on
constexpr float kGetsOnAbove = 0.15F;        ///< m/s
constexpr float kGivesWayWithin = 3.0F;      ///< metres before whom he follows
constexpr float kLaneMetres = 0.9F;          ///< to either side of where that one wants to go

/// m/s of who follows somebody of that speed from `behind` (metres) further away than he is to.
float catchingUp(float speed, float behind)
{
    return speed * (1.0F + kHaste * std::clamp(behind / kFarBehind, 0.0F, 1.0F));
}

} // namespace

/// kNone: he is not here.
std::uint32_t RuleEngine::agentNamed(model::IndividualId id) const
{
    const auto found =
        std::ranges::lower_bound(m_agentOf, id, {}, [](const auto& entry) { return entry.first; });
    return found != m_agentOf.end() && found->first == id ? found->second : kNone;
}

std::uint32_t RuleEngine::nearestTagged(RuleHost& host, std::uint32_t agent, std::uint8_t tag)
{
    const auto [entry, isNew] = m_tagged.try_emplace(tag);
    for (std::uint32_t other = 0; isNew && other < m_minds.size(); ++other) {
        if ((m_minds[other].tags >> tag & 1U) != 0 && !host.isGone(other)) {
            entry->second.add(other, host.position(other));
        }
    }
    return entry->second.nearest(host.position(agent), std::numeric_limits<float>::max(), agent);
}

/// Nothing: there is nobody and no place.
std::optional<RuleEngine::Aim> RuleEngine::aimOf(RuleHost& host, std::uint32_t agent,
                                                 const model::AimChoice& choice)
{
    const Cause& cause = m_minds[agent].cause;
    std::uint32_t whom = kNone;
    switch (choice.aim) {
    case model::ActionAim::Sender:
        whom = cause.sender != 0 ? agentNamed(cause.sender) : kNone;
        if (whom == kNone || host.isGone(whom)) {
            return cause.hasOrigin ? std::optional(Aim{cause.origin, kNone}) : std::nullopt;
        }
        break;
    case model::ActionAim::Tagged:
        whom = nearestTagged(host, agent, choice.tag);
        break;
    case model::ActionAim::Place:
        if (const model::Place* place = m_places.find(choice.place)) {
            return Aim{place->position, kNone};
        }
        complainOf(m_minds[agent].rule,
                   " names a place that is not there any more. Choose another one.");
        break;
    }
    return whom == kNone ? std::nullopt : std::optional(Aim{host.position(whom), whom});
}

/// True: he is there.
bool RuleEngine::flee(RuleHost& host, std::uint32_t agent, const model::actions::Flee& action)
{
    Mind& mind = m_minds[agent];
    if (host.isGone(agent)) {
        return true;
    }
    if (mind.isTravelling) {
        return hasErrandEnded(host, agent);
    }
    mind.isStarted = true;
    mind.isTravelling = true;
    const glm::vec3 at = host.position(agent);
    const std::optional<Aim> from = aimOf(host, agent, action);
    glm::vec3 away = from ? at - from->point : glm::vec3(0.0F);
    away.y = 0.0F;
    const float length = std::sqrt(away.x * away.x + away.z * away.z);
    const float angle = kAllRound * draw(host, agent, 81);
    away = length > 0.05F ? away / length : glm::vec3(std::sin(angle), 0.0F, std::cos(angle));
    mind.goal = 0;
    hold(agent, 0);
    sendTo(host, agent, at + away * action.metres, 0.0F);
    return false;
}

/// Whom somebody goes to: the one that he began with, as long as it can be he.
std::optional<RuleEngine::Aim> RuleEngine::partnerOf(RuleHost& host, std::uint32_t agent,
                                                     const model::AimChoice& choice)
{
    Mind& mind = m_minds[agent];
    const std::uint32_t former = mind.partner != 0 ? agentNamed(mind.partner) : kNone;
    const bool isStill =
        former != kNone && !host.isGone(former) &&
        (choice.aim == model::ActionAim::Sender || (m_minds[former].tags >> choice.tag & 1U) != 0);
    if (isStill) {
        return Aim{host.position(former), former};
    }
    const std::optional<Aim> aim = aimOf(host, agent, choice);
    mind.partner = aim && aim->agent != kNone ? host.id(aim->agent) : 0;
    return aim;
}

/// To somebody, and after him where he is to be followed. True: it is over.
bool RuleEngine::approach(RuleHost& host, std::uint32_t agent, const Approach& action)
{
    Mind& mind = m_minds[agent];
    if (host.isGone(agent)) {
        return true;
    }
    if (!mind.isStarted) {
        mind.isStarted = true;
        mind.until = action.seconds > 0.0F ? m_now + static_cast<double>(action.seconds)
                                           : std::numeric_limits<double>::infinity();
        mind.nextLook = m_now;
        mind.partner = 0;
        mind.isNear = true; // stands, until he sets out
        mind.aimedAt = glm::vec3(std::numeric_limits<float>::max());
        mind.movedAt = m_now;
        mind.goal = 0;
        hold(agent, 0);
    } else if (m_now >= mind.until) {
        host.stop(agent);
        return true;
    }
    if (!action.isFollowing && !mind.isNear && hasErrandEnded(host, agent)) {
        return true; // as near as he gets
    }
    return m_now >= mind.nextLook && comeNear(host, agent, action);
}

/// A look at where the other one is now.
bool RuleEngine::comeNear(RuleHost& host, std::uint32_t agent, const Approach& action)
{
    Mind& mind = m_minds[agent];
    mind.nextLook = m_now + kSecondsBetweenLooks;
    const std::optional<Aim> aim = partnerOf(host, agent, action.aim);
    const bool isFollowing = action.isFollowing;
    if (!aim || (isFollowing && aim->agent == kNone)) {
        if (isFollowing && action.aim.aim == model::ActionAim::Sender) {
            complainOf(mind.rule,
                       " follows whoever sent the event, but it came from a brush, a "
                       "cue or nobody. Let characters send it, or follow those with a tag.");
        }
        host.stop(agent);
        return true;
    }
    const float away = flatDistance(host.position(agent), aim->point);
    const float distance = std::max(action.metres, kLeastDistance);
    if (isFollowing && giveWay(host, agent, aim->agent)) {
        return false;
    }
    const bool isFirst = mind.aimedAt.x == std::numeric_limits<float>::max();
    if (away <= distance + (mind.isNear && !isFirst ? kSetsOutAgain : 0.0F)) {
        if (!mind.isNear || isFirst) {
            host.stop(agent);
        }
        mind.isNear = true;
        mind.aimedAt = aim->point;
        host.turnTo(agent, aim->point); // once he stands: who moves looks ahead
        return !isFollowing && host.speed(agent) < kGetsOnAbove;
    }
    if (host.speed(agent) > kGetsOnAbove) {
        mind.movedAt = m_now;
    } else if (!isFollowing && m_now > mind.movedAt + kPatienceSeconds) {
        host.stop(agent);
        return true; // nobody gets through
    }
    if (mind.isNear || flatDistance(mind.aimedAt, aim->point) > kAimsAnew) {
        const float angle =
            kAllRound * model::unitFloat(model::hashKeys(m_seed, host.id(agent), 84));
        const float atLeast =
            isFollowing ? catchingUp(host.speed(aim->agent), away - distance) : 0.0F;
        sendTo(host, agent,
               aim->point + kBeside * glm::vec3(std::sin(angle), 0.0F, std::cos(angle)), atLeast);
        mind.aimedAt = aim->point;
        mind.isNear = false;
    }
    return false;
}

/// Out of the way of whom he follows, to the side on which he stands. False: he is not in it.
bool RuleEngine::giveWay(RuleHost& host, std::uint32_t agent, std::uint32_t other)
{
    const glm::vec2 wanted = host.wantedVelocity(other);
    const float speed = std::sqrt(wanted.x * wanted.x + wanted.y * wanted.y);
    if (speed < kGetsOnAbove) {
        return false;
    }
    const glm::vec2 ahead = wanted / speed;
    const glm::vec3 way = host.position(agent) - host.position(other);
    const float before = way.x * ahead.x + way.z * ahead.y;
    const float beside = way.x * ahead.y - way.z * ahead.x;
    if (before < 0.0F || before > kGivesWayWithin || std::fabs(beside) > kLaneMetres) {
        return false;
    }
    const float side = (beside < 0.0F ? -1.0F : 1.0F) * (kLaneMetres + kBeside);
    const glm::vec3 aside(ahead.y * side, 0.0F, -ahead.x * side);
    const glm::vec3 level(ahead.x * before, 0.0F, ahead.y * before);
    Mind& mind = m_minds[agent];
    mind.isNear = false;
    mind.aimedAt = glm::vec3(std::numeric_limits<float>::max());
    mind.movedAt = m_now;
    sendTo(host, agent, host.position(other) + level + aside, 0.0F);
    return true;
}

bool RuleEngine::lookAtAim(RuleHost& host, std::uint32_t agent,
                           const model::actions::LookAt& action)
{
    Mind& mind = m_minds[agent];
    if (!mind.isStarted) {
        mind.isStarted = true;
        mind.until = action.seconds > 0.0F ? m_now + static_cast<double>(action.seconds)
                                           : std::numeric_limits<double>::infinity();
        mind.nextLook = m_now;
    }
    if (m_now < mind.nextLook) {
        return m_now >= mind.until;
    }
    mind.nextLook = m_now + kSecondsBetweenLooks;
    const std::optional<Aim> aim = aimOf(host, agent, action);
    if (aim) {
        host.turnTo(agent, aim->point);
    } else if (action.aim == model::ActionAim::Sender) {
        return true; // there is nothing to look at, nor will there be
    }
    return m_now >= mind.until;
}

} // namespace crowd::behavior
