// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "behavior/rules/RuleEngine.h"
#include "behavior/session/PathFollower.h"
#include "model/base/Random.h"
#include "model/base/WeightedDraw.h"

/// What rules let people do.
namespace crowd::behavior {

namespace {

constexpr std::size_t kMaxEvents = 500'000;
constexpr float kFullTurn = 6.2831853F;
constexpr double kSecondsToAskAgain = 1.0 / 3.0; ///< for a free place

} // namespace

std::string RuleEngine::drawClip(RuleHost& host, std::uint32_t agent,
                                 const model::Action& action) const
{
    if (action.clips.empty()) {
        return {};
    }
    const float share = draw(host, agent, model::hashKeys(m_minds[agent].action, 71));
    return action
        .clips[model::weightedIndex(action.clips, share,
                                    [](const auto& clip) { return clip.weight; })]
        .clip;
}

bool RuleEngine::play(RuleHost& host, std::uint32_t agent, const model::Action& action)
{
    Mind& mind = m_minds[agent];
    if (mind.isStarted) {
        if (m_now < mind.until) {
            return false;
        }
        host.endClip(agent);
        for (std::uint32_t rule = 0; rule < m_rules.size(); ++rule) {
            if (m_rules[rule].trigger.kind == model::TriggerKind::ClipEnded && rule != mind.rule) {
                mind.queue.push_back({m_rules[rule].id, mind.cause});
            }
        }
        return true;
    }
    const std::string clip = drawClip(host, agent, action);
    const float seconds = clip.empty() ? -1.0F : host.play(agent, clip, action.isLooped);
    mind.until = m_now + static_cast<double>(action.isLooped ? action.seconds : seconds);
    mind.isStarted = true;
    return seconds < 0.0F; // he has no such clip: on to the next action
}

void RuleEngine::changeTags(RuleHost& host, std::uint32_t agent, const model::Action& action)
{
    std::uint64_t& tags = m_minds[agent].tags;
    const std::uint64_t bit = std::uint64_t{1} << action.tag;
    const std::uint64_t now = action.kind == model::ActionKind::AddTag ? tags | bit : tags & ~bit;
    if (now != tags) {
        tags = now;
        host.noteTags(agent, now);
    }
}

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

/// True: there is nowhere to go, and nothing to wait for.
bool RuleEngine::setOut(RuleHost& host, std::uint32_t agent, const model::Action& action)
{
    Mind& mind = m_minds[agent];
    const bool isLeaving = action.kind == model::ActionKind::LeaveScene;
    const model::PlaceChoice choice = isLeaving ? model::PlaceChoice::Given : action.choice;
    if (choice == model::PlaceChoice::Given && m_places.find(action.place) == nullptr) {
        complainOf(mind.rule,
                   " sends people to a place that is not there any more. Choose another one.");
        return true;
    }
    if (choice != model::PlaceChoice::Given && choice != model::PlaceChoice::Nearest) {
        (void)rooms(host);
    }
    const auto place =
        m_places.choose(choice, action.place, action.path, host.position(agent), mind.holds);
    if (!place) {
        // Until a place is free he goes on with what he does.
        mind.isStarted =
            choice == model::PlaceChoice::NearestFree || choice == model::PlaceChoice::FirstFree;
        mind.until = m_now + kSecondsToAskAgain;
        return !mind.isStarted;
    }
    mind.isStarted = true;
    mind.isTravelling = true;
    mind.goal = *place;
    hold(agent, *place);
    host.sendTo(agent, pointIn(host, agent, *m_places.find(*place)), 0.0F);
    return false;
}

bool RuleEngine::travel(RuleHost& host, std::uint32_t agent, const model::Action& action)
{
    Mind& mind = m_minds[agent];
    if (host.isGone(agent)) {
        return true;
    }
    if (mind.isTravelling) {
        return (host.happenings()[agent] & PathFollower::EndedErrand) != 0;
    }
    if (action.kind == model::ActionKind::Flee) {
        mind.isStarted = true;
        mind.isTravelling = true;
        flee(host, agent, action);
        return false;
    }
    return (!mind.isStarted || m_now >= mind.until) && setOut(host, agent, action);
}

bool RuleEngine::sitDown(RuleHost& host, std::uint32_t agent, const model::Action& action)
{
    Mind& mind = m_minds[agent];
    if (mind.isStarted || host.isSeated(agent) || host.isGone(agent)) {
        return !host.isSittingDown(agent);
    }
    mind.isStarted = true;
    if (!host.sit(agent, action.metres)) {
        return true; // no seat is free: on to the next action
    }
    mind.goal = 0;
    hold(agent, 0);
    return false;
}

bool RuleEngine::standUp(RuleHost& host, std::uint32_t agent)
{
    Mind& mind = m_minds[agent];
    if (!mind.isStarted) {
        if (!host.isSeated(agent)) {
            return true;
        }
        mind.isStarted = true;
        mind.until = m_now + static_cast<double>(host.standUp(agent));
    }
    if (m_now < mind.until) {
        return false;
    }
    host.leaveSeat(agent);
    return true;
}

bool RuleEngine::wait(RuleHost& host, std::uint32_t agent, const model::Action& action)
{
    Mind& mind = m_minds[agent];
    const bool isForEvent = action.kind == model::ActionKind::WaitForEvent;
    if (!mind.isStarted) {
        mind.isStarted = true;
        mind.hasHeard = false;
        const float share =
            isForEvent ? 1.0F : 0.5F + draw(host, agent, model::hashKeys(mind.action, 91));
        mind.until = isForEvent && action.seconds <= 0.0F
                         ? std::numeric_limits<double>::infinity()
                         : m_now + static_cast<double>(action.seconds * share);
    }
    return m_now >= mind.until || (isForEvent && mind.hasHeard);
}

bool RuleEngine::isMeant(RuleHost& host, const model::Action& action, std::uint32_t agent,
                         std::uint32_t other) const
{
    if (action.reach == model::EventReach::Self) {
        return other == agent;
    }
    if (other == agent) {
        return false;
    }
    switch (action.reach) {
    case model::EventReach::Near:
        return !host.isGone(other) &&
               flatDistance(host.position(other), host.position(agent)) <= action.metres;
    case model::EventReach::Tagged:
        return (m_minds[other].tags >> action.tag & 1U) != 0;
    case model::EventReach::Group:
        return host.group(other) == host.group(agent);
    case model::EventReach::Self:
    case model::EventReach::Everybody:
        break;
    }
    return true;
}

void RuleEngine::send(RuleHost& host, std::uint32_t agent, const model::Action& action)
{
    if (m_events.size() > kMaxEvents) {
        complainOf(m_minds[agent].rule,
                   " sends more events than can be under way; further ones are dropped. It may be "
                   "sending events that make it send again: give it a pause, or say how often at "
                   "most.");
        return;
    }
    const glm::vec3 at = host.position(agent);
    for (std::uint32_t other = 0; other < m_minds.size(); ++other) {
        if (isMeant(host, action, agent, other)) {
            const float away = host.isGone(other) ? 0.0F : flatDistance(host.position(other), at);
            const double delay = static_cast<double>(away * action.secondsPerMetre);
            post({m_now + delay, m_order++, action.event, action.value, host.id(other), at,
                  host.id(agent)});
        }
    }
}

void RuleEngine::changeNumber(std::uint32_t agent, const model::Action& action)
{
    Mind& mind = m_minds[agent];
    const auto found = std::ranges::find(m_numbers, action.number, &model::NumberName::id);
    if (found == m_numbers.end()) {
        complainOf(mind.rule, " changes a number that is not there any more. Choose another one.");
        return;
    }
    float& number = mind.numbers[static_cast<std::size_t>(found - m_numbers.begin())];
    number = std::clamp(action.kind == model::ActionKind::SetNumber ? action.value
                                                                    : number + action.value,
                        -model::kMaxNumber, model::kMaxNumber);
    m_areNumbersStale = true;
}

bool RuleEngine::run(RuleHost& host, std::uint32_t agent, const model::Action& action)
{
    Mind& mind = m_minds[agent];
    switch (action.kind) {
    case model::ActionKind::PlayClip:
        return play(host, agent, action);
    case model::ActionKind::FollowPath:
        if (host.follow(agent, action.path)) {
            hold(agent, 0);
        } else {
            complainOf(mind.rule, " lets people follow a path that is not there any more. Choose "
                                  "another one.");
        }
        return true;
    case model::ActionKind::GoToPlace:
    case model::ActionKind::Flee:
        return travel(host, agent, action);
    case model::ActionKind::Stop:
        host.stop(agent);
        return true;
    case model::ActionKind::GoOn:
        hold(agent, 0);
        host.goOn(agent);
        return true;
    case model::ActionKind::Wait:
    case model::ActionKind::WaitForEvent:
        return wait(host, agent, action);
    case model::ActionKind::SetSpeed:
        host.setPace(agent, action.value > 0.0F ? action.value : mind.cause.payload);
        return true;
    case model::ActionKind::TurnTo:
        if (const std::optional<Aim> aim = aimOf(host, agent, action)) {
            host.turnTo(agent, aim->point);
        }
        return true;
    case model::ActionKind::AddTag:
    case model::ActionKind::RemoveTag:
        changeTags(host, agent, action);
        return true;
    case model::ActionKind::SendEvent:
        send(host, agent, action);
        return true;
    case model::ActionKind::LeaveScene:
        if (action.place != 0 && !travel(host, agent, action)) {
            return false;
        }
        hold(agent, 0);
        host.leave(agent);
        return true;
    case model::ActionKind::Again:
    case model::ActionKind::Repeat:
    case model::ActionKind::OneOf:
        return true; // see branch()
    case model::ActionKind::SitDown:
        return sitDown(host, agent, action);
    case model::ActionKind::StandUp:
        return standUp(host, agent);
    case model::ActionKind::SetNumber:
    case model::ActionKind::AddToNumber:
        changeNumber(agent, action);
        return true;
    case model::ActionKind::Appear:
        if (const model::Place* place = m_places.find(action.place)) {
            host.appear(agent, pointIn(host, agent, *place));
        } else {
            complainOf(mind.rule,
                       " lets people appear at a place that is not there any more. Choose "
                       "another one.");
        }
        return true;
    case model::ActionKind::GoToPerson:
    case model::ActionKind::Follow:
        return approach(host, agent, action);
    case model::ActionKind::LookAt:
        return lookAtAim(host, agent, action);
    case model::ActionKind::SetProperty:
        host.setProperty(agent, action, drawClip(host, agent, action));
        return true;
    }
    return true;
}

} // namespace crowd::behavior
