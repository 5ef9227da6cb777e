// SPDX-License-Identifier: MIT
#include "behavior/agents/ClipAnimation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crowd::behavior {

namespace {

constexpr float kRunsAbove = 2.0F;       ///< m/s
constexpr float kShortestSeconds = 0.1F; ///< that a rule waits for a clip

} // namespace

float ClipAnimation::play(std::uint32_t agent, const std::string& name, bool isLooped)
{
    const std::uint32_t table = m_agents.table[agent];
    const int clip = m_templates.clipNamed(table, name);
    if (clip < 0) {
        return -1.0F;
    }
    State& state = m_states[agent];
    state.clip = clip;
    state.isLooped = isLooped;
    state.endsByItself = false;
    state.place = 0.0;
    m_agents.activate(agent);
    return std::max(kShortestSeconds, m_templates.clip(table, clip)->seconds);
}

void ClipAnimation::playOnce(std::uint32_t agent, int clip, bool endsByItself)
{
    State& state = m_states[agent];
    state.clip = clip;
    state.isLooped = false;
    state.endsByItself = endsByItself;
    state.place = 0.0;
    m_agents.markDirty(agent);
}

void ClipAnimation::endClip(std::uint32_t agent)
{
    m_states[agent].clip = -1;
    m_agents.markDirty(agent);
}

void ClipAnimation::resume(std::uint32_t agent, const ClipPlace& shown, bool isClock,
                           bool isEndless)
{
    State& state = m_states[agent];
    MotionState& m = m_agents.motion;
    const GaitTable* gaits = m_templates.gaits(m_agents.table[agent]);
    const bool isGait = !isClock && gaits != nullptr && gaits->isMover(shown.clip);
    state.gait = isGait ? static_cast<std::uint32_t>(gaits->gaitOf(shown.clip)) : 0;
    state.lastGait = state.gait;
    if (isGait) {
        m.gaitPlace[agent] = static_cast<float>(shown.place);
    } else if (!isClock) {
        playOnce(agent, shown.clip, !isEndless);
        state.isLooped = isEndless;
        state.place = std::clamp(shown.place, 0.0, 1.0);
    }
    m.clip[agent] = shown.clip;
    m.rate[agent] = shown.rate;
    m.clipSeconds[agent] = shown.clipSeconds;
    m.place[agent] = static_cast<float>(shown.place);
    m.flags[agent] =
        static_cast<std::uint8_t>((shown.isLooped ? kPoseLooped : 0) | (isClock ? kPoseClock : 0));
    state.hasShown = true;
    m_agents.activate(agent);
}

void ClipAnimation::cut(std::uint32_t agent)
{
    m_states[agent].hasShown = false;
    m_states[agent].fadeBegin = -1.0;
}

void ClipAnimation::forgetGaits(std::uint32_t agent)
{
    m_states[agent].gait = 0;
    m_states[agent].lastGait = 0;
    m_states[agent].fromGait = 0;
}

void ClipAnimation::advanceClip(std::uint32_t agent)
{
    State& state = m_states[agent];
    const TemplateTables::ClipFacts* facts = m_templates.clip(m_agents.table[agent], state.clip);
    if (facts == nullptr) {
        return;
    }
    state.place += facts->seconds > 0.0F ? static_cast<double>(m_clock.stepSeconds) /
                                               static_cast<double>(facts->seconds)
                                         : 0.0;
    state.place =
        state.isLooped ? state.place - std::floor(state.place) : std::min(state.place, 1.0);
    if (state.endsByItself && state.place >= 1.0) {
        state.clip = -1;
    }
}

std::uint32_t ClipAnimation::chooseGait(const State& state, const GaitTable& gaits,
                                        float metresPerSecond, bool wantsOn) const
{
    // Who comes to rest finishes with the walk that it has.
    const bool keepsGait =
        !wantsOn && state.gait != 0 && gaits.gait(state.gait).metresPerSecond < kRunsAbove;
    return static_cast<std::uint32_t>(
        gaits.choose(state.gait, metresPerSecond, keepsGait ? state.gait : state.style));
}

/// Feet set off and come to rest with the body; in between the gait changes only where the feet
/// pass each other.
void ClipAnimation::updateGait(std::uint32_t agent, float bodySpeed, bool wantsOn)
{
    const GaitTable* gaits = m_templates.gaits(m_agents.table[agent]);
    if (gaits == nullptr) {
        return;
    }
    State& state = m_states[agent];
    MotionState& motion = m_agents.motion;
    const float smooth = motion.speed[agent];
    const bool stood = state.gait == 0;
    const float metresPerSecond = !wantsOn ? bodySpeed
                                  : stood  ? std::max(bodySpeed, smooth)
                                           : smooth;
    const GaitTable::Gait& former = gaits->gait(state.gait);
    const std::uint32_t chosen = chooseGait(state, *gaits, metresPerSecond, wantsOn);
    const GaitTable::Gait& gait = gaits->gait(chosen);
    auto place = static_cast<double>(motion.gaitPlace[agent]);
    if (stood && chosen != 0) {
        place = GaitTable::nearestTogether(gait, place);
        motion.speed[agent] = std::max(smooth, metresPerSecond);
    }
    if (stood || chosen == 0) {
        state.gait = chosen;
    } else if (chosen != state.gait && GaitTable::isAboutToPass(former, place)) {
        place = GaitTable::placeInto(former, gait, place);
        state.gait = chosen;
    }
    const GaitTable::Gait& present = gaits->gait(state.gait);
    if (present.seconds > 0.0F) {
        const float rate =
            GaitTable::playback(present, motion.stride[agent], m_agents.height[agent]);
        place +=
            static_cast<double>(rate * m_clock.stepSeconds) / static_cast<double>(present.seconds);
        place -= std::floor(place);
    }
    motion.gaitPlace[agent] = static_cast<float>(place);
}

bool ClipAnimation::isFading(const State& state) const
{
    return state.fadeBegin >= 0.0 && m_clock.seconds() - state.fadeBegin < kFadeSeconds;
}

/// Where it is another clip than a step ago, the former one fades out.
void ClipAnimation::updateShownClip(std::uint32_t agent)
{
    State& state = m_states[agent];
    MotionState& m = m_agents.motion;
    const Shown now = shown(agent);
    if (state.hasShown && m.clip[agent] != now.clip.clip) {
        ClipPlace last{m.clip[agent], (m.flags[agent] & kPoseLooped) != 0, m.rate[agent],
                       m.clipSeconds[agent], static_cast<double>(m.place[agent])};
        if ((m.flags[agent] & kPoseClock) != 0) {
            last.place = last.placeAt(m_clock.seconds() - static_cast<double>(m_clock.stepSeconds));
        }
        state.from = last;
        state.fromGait = state.lastGait;
        state.fadeBegin = m_clock.seconds();
    }
    advanceFade(agent);
    m.clip[agent] = now.clip.clip;
    m.rate[agent] = now.clip.rate;
    m.clipSeconds[agent] = now.clip.clipSeconds;
    m.place[agent] = static_cast<float>(now.clip.place);
    m.isGaitShown[agent] = now.isGait ? -1 : 0;
    m.flags[agent] = flags(agent, now);
    state.lastGait = m_templates.gaits(m_agents.table[agent]) != nullptr ? state.gait : 0;
    state.hasShown = true;
}

/// The clip that fades out goes on too; where it is a gait, at the pace of the body.
void ClipAnimation::advanceFade(std::uint32_t agent)
{
    State& state = m_states[agent];
    if (!isFading(state)) {
        return;
    }
    const GaitTable* gaits = m_templates.gaits(m_agents.table[agent]);
    if (state.fromGait != 0 && gaits != nullptr) {
        state.from.rate = GaitTable::playback(
            gaits->gait(state.fromGait), m_agents.motion.stride[agent], m_agents.height[agent]);
    }
    if (state.from.clipSeconds > 0.0F) {
        state.from.place += static_cast<double>(m_clock.stepSeconds * state.from.rate) /
                            static_cast<double>(state.from.clipSeconds);
    }
}

std::uint8_t ClipAnimation::flags(std::uint32_t agent, const Shown& shown) const
{
    return static_cast<std::uint8_t>(
        (m_agents.motion.flags[agent] & kPoseLive) | (shown.clip.isLooped ? kPoseLooped : 0) |
        (m_agents.isGone[agent] != 0 ? kPoseGone : 0) | (shown.isClock ? kPoseClock : 0) |
        (isFading(m_states[agent]) ? kPoseFading : 0));
}

/// The kernel takes over where nothing but the gait goes on; it is told the limits of that.
void ClipAnimation::setUpdateMode(std::uint32_t agent)
{
    const State& state = m_states[agent];
    MotionState& m = m_agents.motion;
    const bool fades = (m.flags[agent] & kPoseFading) != 0;
    if (state.clip >= 0 || m_agents.isTurning[agent] != 0 || fades ||
        m_agents.isSettlingOrSeated(agent)) {
        m_agents.markDirty(agent);
        return;
    }
    m.mode[agent] = static_cast<std::int32_t>(UpdateMode::Continue);
    const GaitTable* gaits = m_templates.gaits(m_agents.table[agent]);
    if (gaits == nullptr) {
        m.perMetre[agent] = 0.0F;
        m.perSecond[agent] = 0.0F;
        m.slowest[agent] = -1.0F;
        m.fastest[agent] = std::numeric_limits<float>::infinity();
        return;
    }
    const GaitTable::Gait& gait = gaits->gait(state.gait);
    const GaitTable::Limits limits = gaits->limits(state.gait, state.style);
    m.perMetre[agent] = gait.metresPerSecond > 0.0F && !gait.isFree
                            ? GaitTable::playback(gait, 1.0F, m_agents.height[agent])
                            : 0.0F;
    m.perSecond[agent] = gait.seconds > 0.0F && !gait.isFrozen ? 1.0F / gait.seconds : 0.0F;
    m.slowest[agent] = limits.slowest;
    m.fastest[agent] = limits.fastest;
}

ClipAnimation::Shown ClipAnimation::shown(std::uint32_t agent) const
{
    const State& state = m_states[agent];
    const std::uint32_t table = m_agents.table[agent];
    const GaitTable* gaits = m_templates.gaits(table);
    const std::uint32_t gait = gaits != nullptr ? state.gait : 0;
    const TemplateTables::ClipFacts* facts = m_templates.clip(table, state.clip);
    if (facts != nullptr && gait == 0) {
        return {{static_cast<std::uint16_t>(state.clip), facts->isLooped, 1.0F, facts->seconds,
                 state.place}};
    }
    const std::uint16_t idle = m_idle.clip(agent);
    const TemplateTables::ClipFacts* idleFacts = m_templates.clip(table, idle);
    const bool isMover = idleFacts != nullptr && idleFacts->isMover;
    if (gaits == nullptr || (gait == 0 && !isMover)) {
        return {{idle, idleFacts == nullptr || idleFacts->isLooped, m_idle.rate(agent),
                 idleFacts == nullptr ? 0.0F : idleFacts->seconds, m_idle.phase(agent)},
                false,
                true};
    }
    const MotionState& m = m_agents.motion;
    const GaitTable::Gait& chosen = gaits->gait(gait);
    return {{chosen.clip, true,
             GaitTable::playback(chosen, m.stride[agent], m_agents.height[agent]), chosen.seconds,
             static_cast<double>(m.gaitPlace[agent])},
            true};
}

float ClipAnimation::braking(std::uint32_t agent, float metresPerSecond) const
{
    const GaitTable* gaits = m_templates.gaits(m_agents.table[agent]);
    if (gaits == nullptr) {
        return 0.0F;
    }
    const auto place = static_cast<double>(m_agents.motion.gaitPlace[agent]);
    return GaitTable::braking(gaits->gait(m_states[agent].gait), place, metresPerSecond,
                              m_agents.height[agent]);
}

} // namespace crowd::behavior
