// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "behavior/rules/RuleEngine.h"
#include "model/base/Random.h"
#include "model/base/WeightedDraw.h"

/// What rules let people do.
namespace crowd::behavior {

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
        m_clipsEnded.push_back({agent, mind.rule, mind.cause});
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
        const auto known = m_carriers.find(action.tag);
        if (known != m_carriers.end() && (now & bit) != 0) {
            std::vector<std::uint32_t>& carriers = known->second;
            const auto at = std::ranges::lower_bound(carriers, agent);
            if (at == carriers.end() || *at != agent) {
                carriers.insert(at, agent);
            }
        }
    }
}

bool RuleEngine::sitDown(RuleHost& host, std::uint32_t agent, const model::Action& action)
{
    Mind& mind = m_minds[agent];
    if (mind.isStarted || host.isSeated(agent) || host.isGone(agent)) {
        return !host.isSittingDown(agent);
    }
    mind.isStarted = true;
    if (!host.sit(agent, action.metres)) {
        if (!host.hasSeats()) {
            complainOf(mind.rule, " lets characters sit down, but the scene has no seats. Bring a "
                                  "stage with seats along.");
        }
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
            complainOf(mind.rule,
                       " lets characters follow a path that is not there any more. Choose "
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
        return leave(host, agent, action);
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
            if (!m_cells.isEmpty()) {
                m_cells.add(agent, host.position(agent));
            }
        } else {
            complainOf(mind.rule,
                       " lets characters appear at a place that is not there any more. Choose "
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
