// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>

#include "behavior/motion/StrideKernel.h"
#include "behavior/rules/RuleEngine.h"
#include "model/base/Random.h"

/// Where rules send people, in whose turn, and how they leave.
namespace crowd::behavior {

namespace {

constexpr float kFullTurn = 6.2831853F;
constexpr float kThereMetres = 1.5F;             ///< beside a place
constexpr double kSecondsToAskAgain = 1.0 / 3.0; ///< for a free place

} // namespace

/// A place counts him as its guest from now on; 0: none does.
void RuleEngine::hold(std::uint32_t agent, model::PlaceId place)
{
    Mind& mind = m_minds[agent];
    if (m_places.isCounted()) {
        m_places.move(mind.holds, place);
    }
    mind.holds = place;
}

glm::vec3 RuleEngine::pointIn(RuleHost& host, std::uint32_t agent, const model::Place& place) const
{
    const float radius = place.radius * std::sqrt(draw(host, agent, model::hashKeys(place.id, 82)));
    const float angle = kFullTurn * draw(host, agent, model::hashKeys(place.id, 83));
    return host.reached(place.position, place.position + radius * glm::vec3(std::sin(angle), 0.0F,
                                                                            std::cos(angle)));
}

RuleEngine::TurnsKey RuleEngine::turnsOf(const PlaceWish& wish)
{
    return {wish.place, wish.path, wish.role == model::PlaceRole::Exit ? 1U : 0U};
}

bool RuleEngine::isWaiting(const Turn& turn) const
{
    const std::uint32_t agent = agentNamed(turn.who);
    return agent != kNone && m_minds[agent].rule != kNone && m_minds[agent].ticket == turn.ticket;
}

/// Nobody waits for such a place for longer than he does.
bool RuleEngine::isHisTurn(std::uint32_t agent, const PlaceWish& wish)
{
    const auto found = m_turns.find(turnsOf(wish));
    if (found == m_turns.end()) {
        return true;
    }
    std::deque<Turn>& turns = found->second;
    while (!turns.empty() && !isWaiting(turns.front())) {
        turns.pop_front();
    }
    return turns.empty() || turns.front().who == m_agentOf[agent].first;
}

/// Until one is free he goes on with what he does.
void RuleEngine::waitForPlace(std::uint32_t agent, const PlaceWish& wish)
{
    Mind& mind = m_minds[agent];
    mind.isStarted = true;
    mind.until = m_now + kSecondsToAskAgain;
    if (mind.ticket == 0) {
        mind.ticket = ++m_tickets;
        m_turns[turnsOf(wish)].push_back({mind.ticket, m_agentOf[agent].first});
    }
}

void RuleEngine::sayNowhere(std::uint32_t rule, const PlaceWish& wish)
{
    const bool isLeaving = wish.role == model::PlaceRole::Exit;
    if (wish.choice == model::PlaceChoice::Given) {
        complainOf(rule,
                   " sends characters to a place that is not there any more. Choose another one.");
    } else if (wish.path != 0) {
        complainOf(rule, " sends characters to places of a path that is not there any more, or has "
                         "none. Choose another one.");
    } else if (wish.place != 0) {
        complainOf(rule, " sends characters to places by a name that none has any more. Choose "
                         "another one.");
    } else {
        complainOf(rule, isLeaving
                             ? " lets characters leave at an exit, but there is none: they stay. "
                               "Paint one with the environment brush."
                             : " sends characters to a place, but there is none. Paint one with "
                               "the path brush.");
    }
}

/// True: there is nowhere to go, and nothing to wait for.
bool RuleEngine::setOut(RuleHost& host, std::uint32_t agent, const PlaceWish& wish)
{
    Mind& mind = m_minds[agent];
    const bool isForFree = wish.choice == model::PlaceChoice::NearestFree ||
                           wish.choice == model::PlaceChoice::FirstFree;
    if (!m_places.hasAny(wish)) {
        sayNowhere(mind.rule, wish);
    }
    if (isForFree || wish.choice == model::PlaceChoice::Ahead) {
        (void)rooms(host);
    }
    const bool mayChoose =
        !isForFree || m_places.isAmong(wish, mind.holds) || isHisTurn(agent, wish);
    const glm::vec3 at = host.position(agent);
    const auto wayTo = [&](const model::Place& to) {
        return host.wayMetres(at, to.position, to.radius + kThereMetres);
    };
    const auto place =
        mayChoose ? m_places.choose(wish, at, mind.holds, wayTo) : std::optional<model::PlaceId>();
    if (!place) {
        if (isForFree) {
            waitForPlace(agent, wish);
        }
        return !isForFree;
    }
    mind.isStarted = true;
    mind.isTravelling = true;
    mind.ticket = 0;
    goToPlace(host, agent, *place);
    return false;
}

void RuleEngine::goToPlace(RuleHost& host, std::uint32_t agent, model::PlaceId place)
{
    m_minds[agent].goal = place;
    m_minds[agent].until = m_now + kSecondsToAskAgain;
    hold(agent, place);
    sendTo(host, agent, pointIn(host, agent, *m_places.find(place)), 0.0F);
}

/// On his way to the end of a line he goes further up as that gets shorter, so that those behind
/// him can set out too.
void RuleEngine::closeUp(RuleHost& host, std::uint32_t agent, PlaceWish wish)
{
    Mind& mind = m_minds[agent];
    mind.until = m_now + kSecondsToAskAgain;
    if (!m_places.isLine(wish)) {
        return;
    }
    wish.choice = model::PlaceChoice::Ahead;
    (void)rooms(host);
    if (const auto place = m_places.choose(wish, host.position(agent), mind.holds)) {
        goToPlace(host, agent, *place);
    }
}

bool RuleEngine::travel(RuleHost& host, std::uint32_t agent, const PlaceWish& wish)
{
    Mind& mind = m_minds[agent];
    if (host.isGone(agent)) {
        return true;
    }
    if (mind.isTravelling) {
        const bool isOver = hasErrandEnded(host, agent);
        if (!isOver && wish.choice == model::PlaceChoice::FirstFree && m_now >= mind.until) {
            closeUp(host, agent, wish);
        }
        return isOver;
    }
    return (!mind.isStarted || m_now >= mind.until) && setOut(host, agent, wish);
}

/// Where he is, or where he is to go first; who has nowhere to leave at stays.
bool RuleEngine::leave(RuleHost& host, std::uint32_t agent,
                       const model::actions::LeaveScene& action)
{
    const bool isHere = action.isHere();
    const PlaceWish wish{action.choice, action.place, action.path, model::PlaceRole::Exit};
    if (!isHere && !travel(host, agent, wish)) {
        return false;
    }
    const bool isThere = isHere || host.isGone(agent) || isAtGoal(host, agent, 0.0F);
    const float speed = host.speed(agent);
    if (isThere) {
        hold(agent, 0);
        host.leave(agent);
    } else if (isAtGoal(host, agent, speed * speed / (2.0F * kUsualBraking))) {
        // Who runs begins to come to rest before he is there: on, up to its middle.
        sendTo(host, agent, m_places.find(m_minds[agent].goal)->position, 0.0F);
        return false;
    } else if (m_minds[agent].isTravelling) {
        complainOf(m_minds[agent].rule,
                   " lets characters leave at \"" + m_places.find(m_minds[agent].goal)->name +
                       "\", but some do not get there: they stay. Move it, or choose another one.");
    }
    return true;
}

/// As near to it as others let him, or so many metres before that.
bool RuleEngine::isAtGoal(RuleHost& host, std::uint32_t agent, float ahead) const
{
    const Mind& mind = m_minds[agent];
    const model::Place* place = mind.isTravelling ? m_places.find(mind.goal) : nullptr;
    return place != nullptr && flatDistance(place->position, host.position(agent)) <=
                                   place->radius + kThereMetres + ahead;
}

/// How many have taken the places, as of now.
PlaceRooms& RuleEngine::rooms(RuleHost& host)
{
    if (!m_places.isCounted()) {
        std::vector<PlaceRooms::Guest> guests;
        guests.reserve(m_minds.size());
        for (std::uint32_t agent = 0; agent < m_minds.size(); ++agent) {
            if (!host.isGone(agent)) {
                guests.push_back({host.position(agent), m_minds[agent].holds});
            }
        }
        m_places.count(guests);
    }
    return m_places;
}

} // namespace crowd::behavior
