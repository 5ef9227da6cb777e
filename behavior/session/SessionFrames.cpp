// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "behavior/session/Session.h"

/// What a session lets others see of its people.
namespace crowd::behavior {

SessionPosePtr Session::pose() const
{
    auto pose = std::make_shared<SessionPose>();
    pose->step = m_steps;
    pose->seconds = seconds();
    pose->hasSeats = m_hasSat;
    pose->looks = m_shownLooks;
    pose->numbers = m_ownNumbers;
    std::vector<std::uint32_t> live;
    live.reserve(m_shown.size());
    for (std::uint32_t agent = 0; agent < m_shown.size(); ++agent) {
        if (isLive(agent)) {
            live.push_back(agent);
        }
    }
    addTo(*pose, live);
    pose->gone = static_cast<std::size_t>(std::ranges::count_if(
        pose->flags, [](std::uint8_t flags) { return (flags & kPoseGone) != 0; }));
    for (const std::uint32_t agent : m_rules.lit()) {
        pose->lit.push_back(m_population.ids()[agent]);
    }
    return pose;
}

/// What these people show, ascending.
void Session::addTo(SessionPose& pose, std::span<const std::uint32_t> agents) const
{
    const auto take = [agents, isAll = agents.size() == m_shown.size()](const auto& from,
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
    const MotionState& b = m_motion;
    take(m_population.ids(), pose.ids);
    take(b.x, pose.x);
    take(b.y, pose.y);
    take(b.z, pose.z);
    take(b.heading, pose.headings);
    take(b.clip, pose.clips);
    take(b.rate, pose.rates);
    take(b.clipSeconds, pose.clipSeconds);
    take(b.place, pose.places);
    take(b.flags, pose.flags);
    for (std::size_t i = 0; i < agents.size(); ++i) {
        const std::uint32_t agent = agents[i];
        if (b.mode[agent] != static_cast<std::int32_t>(UpdateMode::Full)) {
            continue;
        }
        // It may have been written since the last step.
        const Shown& shown = m_shown[agent];
        const Showing showing = showingOf(agent);
        pose.clips[i] = showing.clip.clip;
        pose.rates[i] = showing.clip.rate;
        pose.clipSeconds[i] = showing.clip.clipSeconds;
        pose.places[i] = static_cast<float>(showing.clip.place);
        pose.flags[i] = flagsOf(shown, showing, b.flags[agent]);
        if ((pose.flags[i] & kPoseFading) != 0) {
            pose.fades.push_back({static_cast<std::uint32_t>(i), shown.from, shown.fadeBegin});
        }
    }
    for (std::size_t i = 0; i < agents.size() && m_hasSat; ++i) {
        const Shown& shown = m_shown[agents[i]];
        const bool isOnTheWay = shown.sitting == Sitting::Goes || shown.sitting == Sitting::Settles;
        pose.seats.push_back(isOnTheWay ? model::kNoSeat : shown.seat);
    }
}

model::CrowdFramePtr Session::frame() const
{
    model::CrowdFrame frame{m_population, m_templates, seconds()};
    const SessionPosePtr now = pose();
    applyPose(*now, *now, frame);
    return std::make_shared<const model::CrowdFrame>(std::move(frame));
}

} // namespace crowd::behavior
