// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "behavior/rules/RuleEngine.h"
#include "model/base/Overloaded.h"
#include "model/base/Random.h"
#include "model/base/WeightedDraw.h"

/// What rules let people do.
namespace crowd::behavior {

std::string RuleEngine::drawClip(RuleHost& host, std::uint32_t agent,
                                 const std::vector<model::ClipWeight>& clips) const
{
    if (clips.empty()) {
        return {};
    }
    const float share = draw(host, agent, model::hashKeys(m_minds[agent].action, 71));
    return clips[model::weightedIndex(clips, share, [](const auto& clip) { return clip.weight; })]
        .clip;
}

bool RuleEngine::play(RuleHost& host, std::uint32_t agent, const model::actions::PlayClip& action)
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
    const std::string clip = drawClip(host, agent, action.clips);
    const float seconds = clip.empty() ? -1.0F : host.play(agent, clip, action.isLooped);
    mind.until = m_now + static_cast<double>(action.isLooped ? action.seconds : seconds);
    mind.isStarted = true;
    return seconds < 0.0F; // he has no such clip: on to the next action
}

void RuleEngine::changeTags(RuleHost& host, std::uint32_t agent, std::uint8_t tag, bool hasIt)
{
    std::uint64_t& tags = m_minds[agent].tags;
    const std::uint64_t bit = std::uint64_t{1} << tag;
    const std::uint64_t now = hasIt ? tags | bit : tags & ~bit;
    if (now != tags) {
        tags = now;
        host.noteTags(agent, now);
        const auto known = m_carriers.find(tag);
        if (known != m_carriers.end() && (now & bit) != 0) {
            std::vector<std::uint32_t>& carriers = known->second;
            const auto at = std::ranges::lower_bound(carriers, agent);
            if (at == carriers.end() || *at != agent) {
                carriers.insert(at, agent);
            }
        }
    }
}

bool RuleEngine::sitDown(RuleHost& host, std::uint32_t agent, const model::actions::SitDown& action)
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

bool RuleEngine::wait(RuleHost& host, std::uint32_t agent, const model::actions::Wait& action)
{
    Mind& mind = m_minds[agent];
    if (!mind.isStarted) {
        mind.isStarted = true;
        const float share = 0.5F + draw(host, agent, model::hashKeys(mind.action, 91));
        mind.until = m_now + static_cast<double>(action.seconds * share);
    }
    return m_now >= mind.until;
}

bool RuleEngine::waitForEvent(std::uint32_t agent, const model::actions::WaitForEvent& action)
{
    Mind& mind = m_minds[agent];
    if (!mind.isStarted) {
        mind.isStarted = true;
        mind.hasHeard = false;
        mind.until = action.seconds <= 0.0F ? std::numeric_limits<double>::infinity()
                                            : m_now + static_cast<double>(action.seconds);
    }
    return m_now >= mind.until || mind.hasHeard;
}

void RuleEngine::changeNumber(std::uint32_t agent, model::NumberId id, float value, bool isAdded)
{
    Mind& mind = m_minds[agent];
    const auto found = std::ranges::find(m_numbers, id, &model::NumberName::id);
    if (found == m_numbers.end()) {
        complainOf(mind.rule, " changes a number that is not there any more. Choose another one.");
        return;
    }
    float& number = mind.numbers[static_cast<std::size_t>(found - m_numbers.begin())];
    number = std::clamp(isAdded ? number + value : value, -model::kMaxNumber, model::kMaxNumber);
    m_areNumbersStale = true;
}

void RuleEngine::followPath(RuleHost& host, std::uint32_t agent, model::PathId path)
{
    if (host.follow(agent, path)) {
        hold(agent, 0);
    } else {
        complainOf(
            m_minds[agent].rule,
            " lets characters follow a path that is not there any more. Choose another one.");
    }
}

void RuleEngine::appear(RuleHost& host, std::uint32_t agent, model::PlaceId id)
{
    const model::Place* place = m_places.find(id);
    if (place == nullptr) {
        complainOf(m_minds[agent].rule, " lets characters appear at a place that is not there any "
                                        "more. Choose another one.");
        return;
    }
    host.appear(agent, pointIn(host, agent, *place));
    if (!m_cells.isEmpty()) {
        m_cells.add(agent, host.position(agent));
    }
}

namespace {

/// For actions that are over at once.
template<class Done>
bool once(const Done& done)
{
    done();
    return true;
}

} // namespace

bool RuleEngine::run(RuleHost& host, std::uint32_t agent, const model::Action& action)
{
    using namespace model::actions;
    Mind& mind = m_minds[agent];
    return std::visit(
        model::Overloaded{
            [&](const PlayClip& each) { return play(host, agent, each); },
            [&](const FollowPath& each) {
                return once([&] { followPath(host, agent, each.path); });
            },
            [&](const GoToPlace& each) {
                return travel(host, agent, {each.choice, each.place, each.path});
            },
            [&](const Flee& each) { return flee(host, agent, each); },
            [&](const Stop&) { return once([&] { host.stop(agent); }); },
            [&](const GoOn&) {
                hold(agent, 0);
                return once([&] { host.goOn(agent); });
            },
            [&](const Wait& each) { return wait(host, agent, each); },
            [&](const WaitForEvent& each) { return waitForEvent(agent, each); },
            [&](const SetSpeed& each) {
                const float pace = each.value > 0.0F ? each.value : mind.cause.payload;
                return once([&] { host.setPace(agent, pace); });
            },
            [&](const TurnTo& each) {
                if (const std::optional<Aim> aim = aimOf(host, agent, each)) {
                    host.turnTo(agent, aim->point);
                }
                return true;
            },
            [&](const AddTag& each) {
                return once([&] { changeTags(host, agent, each.tag, true); });
            },
            [&](const RemoveTag& each) {
                return once([&] { changeTags(host, agent, each.tag, false); });
            },
            [&](const SendEvent& each) { return once([&] { send(host, agent, each); }); },
            [&](const LeaveScene& each) { return leave(host, agent, each); },
            [&](const SitDown& each) { return sitDown(host, agent, each); },
            [&](const StandUp&) { return standUp(host, agent); },
            [&](const SetNumber& each) {
                return once([&] { changeNumber(agent, each.number, each.value, false); });
            },
            [&](const AddToNumber& each) {
                return once([&] { changeNumber(agent, each.number, each.value, true); });
            },
            [&](const Appear& each) { return once([&] { appear(host, agent, each.place); }); },
            [&](const GoToPerson& each) {
                return approach(host, agent, {each, each.metres, each.seconds, false});
            },
            [&](const Follow& each) {
                return approach(host, agent, {each, each.metres, each.seconds, true});
            },
            [&](const LookAt& each) { return lookAtAim(host, agent, each); },
            [&](const SetProperty& each) {
                const std::string clip = drawClip(host, agent, each.clips);
                return once([&] { host.setProperty(agent, each, clip); });
            },
            [](const Again&) { return true; }, // see branch()
            [](const Repeat&) { return true; },
            [](const OneOf&) { return true; }},
        action.data);
}

} // namespace crowd::behavior
