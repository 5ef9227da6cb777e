// SPDX-License-Identifier: MIT
#include "behavior/session/PoseCapture.h"

#include <algorithm>
#include <utility>

#include "model/scene/PlaceShape.h"

namespace crowd::behavior {

namespace {

/// The columns of these agents, ascending.
void takeColumns(const SessionParts& parts, std::span<const std::uint32_t> agents,
                 SessionPose& pose)
{
    const auto take = [agents, isAll = agents.size() == parts.agents.size()](const auto& from,
                                                                             auto& to) {
        if (isAll) {
            to.assign(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(agents.size()));
            return;
        }
        to.reserve(agents.size());
        for (const std::uint32_t agent : agents) {
            to.push_back(from[agent]);
        }
    };
    const MotionState& m = parts.agents.motion;
    take(parts.population.ids(), pose.ids);
    take(m.x, pose.x);
    take(m.y, pose.y);
    take(m.z, pose.z);
    take(m.heading, pose.headings);
    take(m.clip, pose.clips);
    take(m.rate, pose.rates);
    take(m.clipSeconds, pose.clipSeconds);
    take(m.place, pose.places);
    take(m.flags, pose.flags);
}

/// Agents that need a full update may have been written since the last step.
void takeLatest(const SessionParts& parts, std::span<const std::uint32_t> agents, SessionPose& pose)
{
    const MotionState& m = parts.agents.motion;
    for (std::size_t i = 0; i < agents.size(); ++i) {
        const std::uint32_t agent = agents[i];
        if (m.mode[agent] != static_cast<std::int32_t>(UpdateMode::Full)) {
            continue;
        }
        const ClipAnimation::Shown shown = parts.animation.shown(agent);
        pose.clips[i] = shown.clip.clip;
        pose.rates[i] = shown.clip.rate;
        pose.clipSeconds[i] = shown.clip.clipSeconds;
        pose.places[i] = static_cast<float>(shown.clip.place);
        pose.flags[i] = parts.animation.flags(agent, shown);
        if ((pose.flags[i] & kPoseFading) != 0) {
            pose.fades.push_back({static_cast<std::uint32_t>(i), parts.animation.fadesFrom(agent),
                                  parts.animation.fadeBegin(agent)});
        }
    }
}

} // namespace

SessionPosePtr capturePose(const SessionParts& parts)
{
    auto pose = std::make_shared<SessionPose>();
    pose->step = parts.clock.steps;
    pose->seconds = parts.clock.seconds();
    pose->hasSeats = parts.seating.hasChanged();
    pose->overrides = parts.shownOverrides;
    pose->numbers = parts.shownNumbers;
    pose->recalled = parts.recalled.columns();
    pose->people = pose->recalled ? parts.population : model::Population();
    pose->sceneVersion = parts.lastScene.population.version();
    pose->stateFades = parts.fades.shown();
    std::vector<std::uint32_t> active;
    active.reserve(parts.agents.size());
    for (std::uint32_t agent = 0; agent < parts.agents.size(); ++agent) {
        if (parts.agents.isActive(agent)) {
            active.push_back(agent);
        }
    }
    takeColumns(parts, active, *pose);
    takeLatest(parts, active, *pose);
    for (std::size_t i = 0; i < active.size() && pose->hasSeats; ++i) {
        pose->seats.push_back(parts.seating.shownSeat(active[i]));
    }
    pose->gone = static_cast<std::size_t>(std::ranges::count_if(
        pose->flags, [](std::uint8_t flags) { return (flags & kPoseGone) != 0; }));
    pose->lightCues = parts.lightCues;
    for (const std::uint32_t agent : parts.rules.lit()) {
        pose->lit.push_back(parts.population.ids()[agent]);
    }
    return pose;
}

model::CrowdFrame captureFrame(const SessionParts& parts)
{
    model::CrowdFrame frame{parts.lastScene.population, parts.templates.entries(),
                            parts.clock.seconds()};
    frame.hiddenGroups = parts.hiddenGroups;
    const SessionPosePtr now = capturePose(parts);
    applyPose(*now, *now, frame);
    return frame;
}

SessionTally countPeople(const SessionParts& parts)
{
    SessionTally tally;
    std::vector<std::uint32_t> inside(parts.places.size());
    for (std::uint32_t agent = 0; agent < parts.agents.size(); ++agent) {
        if (parts.agents.isGone[agent] != 0) {
            continue;
        }
        const model::PathId path = parts.follower.pathOf(agent);
        if (path != 0 && !parts.follower.hasArrived(agent)) {
            ++tally.followers[path];
        }
        const glm::vec3 at = parts.agents.motion.position(agent);
        for (std::size_t i = 0; i < parts.places.size(); ++i) {
            inside[i] += model::isWithin(parts.places[i], at) ? 1U : 0U;
        }
    }
    for (std::size_t i = 0; i < parts.places.size(); ++i) {
        if (inside[i] > 0) {
            tally.inside[parts.places[i].id] = inside[i];
        }
    }
    return tally;
}

} // namespace crowd::behavior
