// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "behavior/agents/AgentColumns.h"
#include "behavior/agents/ClipPlace.h"
#include "behavior/agents/IdleClips.h"
#include "behavior/agents/SessionClock.h"
#include "behavior/agents/TemplateTables.h"

namespace crowd::behavior {

/// Which clip each agent shows and the place in it: the gait that fits its speed, a clip that it
/// was told to play, or its idle clip; and the fade from one to the next. Writes the clip's columns
/// of the motion state. Refers to the others. One thread; the functions of a step may be called for
/// different agents at the same time.
class ClipAnimation
{
public:
    ClipAnimation(const TemplateTables& templates, const SessionClock& clock, const IdleClips& idle,
                  AgentColumns& agents)
        : m_templates(templates), m_clock(clock), m_idle(idle), m_agents(agents)
    {
    }

    void assign(std::size_t agents) { m_states.assign(agents, {}); }
    void rearrange(std::span<const std::uint32_t> keep) { behavior::rearrange(m_states, keep); }

    /// Lets an agent play a clip from its beginning. Seconds that it takes; below 0: its template
    /// has none of that name, and nothing changes.
    float play(std::uint32_t agent, const std::string& clip, bool isLooped);
    /// The same once, by index (-1: none); one that `endsByItself` needs no endClip().
    void playOnce(std::uint32_t agent, int clip, bool endsByItself);
    void endClip(std::uint32_t agent);
    /// As an earlier run has shown it at this moment: a clip that it was told goes on to its end,
    /// or until it is told something else, a gait goes on, and what comes next is faded to.
    /// `isClock`: see Shown.
    void resume(std::uint32_t agent, const ClipPlace& shown, bool isClock, bool isEndless);
    [[nodiscard]] bool isPlaying(std::uint32_t agent) const { return m_states[agent].clip >= 0; }
    /// Gait to move with at any speed; 0: the one that fits.
    void setStyle(std::uint32_t agent, std::uint32_t gait) { m_states[agent].style = gait; }
    /// From standing, with the next gait.
    void stand(std::uint32_t agent) { m_states[agent].gait = 0; }
    /// Shows the next clip at once, without a fade.
    void cut(std::uint32_t agent);
    /// The template has other gaits now.
    void forgetGaits(std::uint32_t agent);

    // A step, in this order.
    void advanceClip(std::uint32_t agent);
    void updateGait(std::uint32_t agent, float metresPerSecond, bool wantsOn);
    void updateShownClip(std::uint32_t agent);
    void setUpdateMode(std::uint32_t agent);

    struct Shown
    {
        ClipPlace clip;
        bool isGait = false;
        bool isClock = false; ///< its place is that at time 0
    };
    [[nodiscard]] Shown shown(std::uint32_t agent) const;
    /// PoseFlag bits.
    [[nodiscard]] std::uint8_t flags(std::uint32_t agent, const Shown& shown) const;
    /// The clip that fades out, and when it began to, seconds.
    [[nodiscard]] const ClipPlace& fadesFrom(std::uint32_t agent) const
    {
        return m_states[agent].from;
    }
    [[nodiscard]] double fadeBegin(std::uint32_t agent) const { return m_states[agent].fadeBegin; }
    /// How it brakes from that speed so that its feet end up together, m/s²; 0: it has no gaits.
    [[nodiscard]] float braking(std::uint32_t agent, float metresPerSecond) const;

private:
    struct State
    {
        std::uint32_t gait = 0;
        std::uint32_t style = 0;
        // The clip that it was told to play.
        int clip = -1; ///< as the clip column counts; -1: none
        bool isLooped = false;
        bool endsByItself = false;
        double place = 0.0;
        // Fading.
        bool hasShown = false; ///< the motion state tells what was shown in the last step
        ClipPlace from;
        std::uint32_t lastGait = 0; ///< of the clip shown; 0: it has a pace of its own
        std::uint32_t fromGait = 0; ///< of `from`
        double fadeBegin = -1.0;    ///< seconds; below 0: none
    };
    void advanceFade(std::uint32_t agent);
    [[nodiscard]] bool isFading(const State& state) const;
    [[nodiscard]] std::uint32_t chooseGait(const State& state, const GaitTable& gaits,
                                           float metresPerSecond, bool wantsOn) const;

    const TemplateTables& m_templates;
    const SessionClock& m_clock;
    const IdleClips& m_idle;
    AgentColumns& m_agents;
    std::vector<State> m_states;
};

} // namespace crowd::behavior
