// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "behavior/agents/ClipPlace.h"
#include "behavior/base/Agents.h"
#include "behavior/motion/MotionState.h"

namespace crowd::behavior {

/// How far an agent has got with sitting down.
enum class SeatPhase : std::uint8_t {
    None,        ///< where the scene has seated it, or it stands
    Approaching, ///< on its way to the seat
    Settling,    ///< the last bit, past whoever sits there
    Seated       ///< since the session let it
};

/// Height of agents that have left the scene, metres: a level of their own, where nobody meets
/// them.
inline constexpr float kGoneHeight = -1e5F;

/// What several components of a session know of each agent, one column each. Whoever writes a
/// column calls markDirty(), so that the next step updates the agent in full. One thread, but for
/// columns of different agents during a step.
struct AgentColumns
{
    MotionState motion;
    std::vector<std::uint32_t> table; ///< index of its template in TemplateTables
    std::vector<float> height;        ///< scale of Y
    std::vector<std::uint8_t> isGone; ///< has left the scene
    std::vector<std::uint8_t> isPut;  ///< was put somewhere: the crowd takes that over once
    std::vector<SeatPhase> seatPhase;
    // Turning on the spot.
    std::vector<std::uint8_t> isTurning;
    std::vector<float> facing; ///< heading that it turns to, radians

    [[nodiscard]] std::size_t size() const { return table.size(); }
    void assign(std::size_t agents)
    {
        motion.assign(agents);
        table.assign(agents, 0);
        height.assign(agents, 1.0F);
        isGone.assign(agents, 0);
        isPut.assign(agents, 0);
        seatPhase.assign(agents, SeatPhase::None);
        isTurning.assign(agents, 0);
        facing.assign(agents, 0.0F);
    }
    void rearrange(std::span<const std::uint32_t> keep)
    {
        motion.rearrange(keep);
        behavior::rearrange(table, keep);
        behavior::rearrange(height, keep, 1.0F);
        behavior::rearrange(isGone, keep);
        behavior::rearrange(isPut, keep);
        behavior::rearrange(seatPhase, keep, SeatPhase::None);
        behavior::rearrange(isTurning, keep);
        behavior::rearrange(facing, keep);
    }

    /// The next step updates the agent in full.
    void markDirty(std::size_t agent)
    {
        motion.mode[agent] = static_cast<std::int32_t>(UpdateMode::Full);
    }
    /// The agent has moved or acted: the session decides what is shown of it, not the scene.
    void activate(std::size_t agent)
    {
        motion.flags[agent] |= kPoseLive;
        markDirty(agent);
    }
    [[nodiscard]] bool isActive(std::size_t agent) const
    {
        return (motion.flags[agent] & kPoseLive) != 0;
    }
    void turnTo(std::size_t agent, float headingRadians)
    {
        facing[agent] = headingRadians;
        isTurning[agent] = 1;
        markDirty(agent);
    }
    [[nodiscard]] bool isSettlingOrSeated(std::size_t agent) const
    {
        return seatPhase[agent] == SeatPhase::Settling || seatPhase[agent] == SeatPhase::Seated;
    }
    [[nodiscard]] bool isOnWayToSeat(std::size_t agent) const
    {
        return seatPhase[agent] == SeatPhase::Approaching ||
               seatPhase[agent] == SeatPhase::Settling;
    }
    /// Its position is the motion state's, whatever the crowd says.
    [[nodiscard]] bool isFixed(std::size_t agent) const
    {
        return isPut[agent] != 0 || isSettlingOrSeated(agent);
    }
};

} // namespace crowd::behavior
