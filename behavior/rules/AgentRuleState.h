// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <glm/vec3.hpp>

#include "behavior/base/Agents.h"
#include "model/population/Columns.h"
#include "model/rules/Rule.h"

/// What the rule engine keeps of each agent, and of each agent per rule. Plain values; world frame,
/// metres, seconds since the session began.
namespace crowd::behavior {

/// Index of a rule among those that run where there is none.
inline constexpr std::uint32_t kNoRule = 0xFFFFFFFFU;
inline constexpr std::uint64_t kNoStep = ~std::uint64_t{0};

/// What made a rule fire, for its conditions and actions to refer to.
struct TriggerContext
{
    float payload = 0.0F;
    glm::vec3 origin{0.0F};
    bool hasOrigin = false;
    model::IndividualId sender = 0; ///< 0: nobody
    /// When the artist made the call that was passed on to here, seconds of the session; below 0:
    /// it begins here.
    double calledAt = -1.0;
};

/// A Repeat whose lines run.
struct LoopFrame
{
    std::uint32_t line = 0;
    std::uint32_t left = 0; ///< repetitions, with the one that runs
};

/// A rule that waits until the agent is free.
struct QueuedRule
{
    model::RuleId rule = 0;
    TriggerContext context;
};

/// Going to somebody, or following.
struct PursuitState
{
    model::IndividualId partner = 0; ///< whom he began with; 0: nobody
    glm::vec3 aimedAt{std::numeric_limits<float>::max()};
    bool isNear = false;
    double movedAt = 0.0;
};

/// How far the action that runs has come. Anew for each action.
struct ActionProgress
{
    bool isStarted = false;
    bool isTravelling = false; ///< until an errand ends
    bool hasHeardEvent = false;
    double until = 0.0;
    double nextUpdate = 0.0;  ///< of where the aim is now
    std::uint64_t ticket = 0; ///< his turn for a free place; 0: he waits for none
    PursuitState pursuit;
};

/// Where a rule has sent him.
struct ErrandState
{
    model::PlaceId goal = 0;    ///< of the errand that he is on or was on last
    model::PlaceId arrived = 0; ///< where an errand ended in this step; 0: at no place
    /// Step in which it began: one that ended in it was the errand before.
    std::uint64_t startedInStep = kNoStep;
};

/// The latest call of an event that he has heard, by its name.
struct HeardCall
{
    std::uint64_t event = 0; ///< hash of its name
    double calledAt = -1.0;
};

/// What rules know of one agent, and what one of them has it do.
struct AgentRuleState
{
    std::uint64_t tags = 0;
    std::uint32_t rule = kNoRule; ///< that runs; set by AgentStates::setRule
    std::uint32_t line = 0;       ///< of its actions
    std::uint32_t firings = 0;    ///< keys the agent's draws
    std::uint32_t branches = 0;   ///< choices and repetitions since the rule began: keys them
    std::vector<LoopFrame> loops; ///< the innermost last
    ActionProgress progress;
    TriggerContext context;
    std::vector<QueuedRule> queue; ///< the next one first
    ErrandState errand;
    model::PlaceId heldPlace = 0; ///< that counts him as its guest; 0: none does
    std::vector<HeardCall> heard; ///< where related people pass events on
};

/// What a rule knows of one agent.
struct RuleAgentState
{
    double lastFired = -1e18;
    double since = -1.0; ///< Waited: when he came to stand; below 0: he does not stand
    std::uint32_t count = 0;
    std::uint32_t echoes = 0; ///< times that it fired right after the last time, by rules
    bool wasThere = false;    ///< Start, Entered, Left, TagNear, SpeedLimit, Waited, AheadFree
    bool isSeen = false;      ///< SpeedLimit: evaluated before
    model::PlaceId place = 0; ///< AheadFree: that he had when it was free last
};

} // namespace crowd::behavior
