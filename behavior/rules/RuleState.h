// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "behavior/rules/AgentStates.h"
#include "behavior/rules/ArtistNumbers.h"
#include "behavior/rules/EventQueue.h"
#include "behavior/rules/FiringLog.h"
#include "behavior/rules/PeopleIndex.h"
#include "behavior/rules/PlaceRooms.h"
#include "behavior/rules/PlaceTurns.h"
#include "behavior/rules/RuleHost.h"
#include "behavior/rules/RuleProblems.h"
#include "model/rules/Rule.h"
#include "model/scene/Relation.h"

/// What the stages of the rule engine work on: they are free functions over it, so that each can be
/// tried with a state that a test has made.
namespace crowd::behavior {

inline constexpr double kDueUnknown = -1.0;

/// A rule that runs, and what it knows of each agent.
struct ActiveRule
{
    model::Rule data;
    bool reachesGone = false; ///< evaluated for those too who have left
    std::vector<RuleAgentState> agents{};
    /// Every: when it fires next, by agent, seconds, or kDueUnknown. Apart, as all are looked
    /// through in each step.
    std::vector<double> due{};
};

/// A clip that a rule let somebody play is over.
struct EndedClip
{
    std::uint32_t agent = 0;
    std::uint32_t rule = kNoRule;
    TriggerContext context;
};

/// Somebody bears another value of a feature than before; 0: none.
struct ChangedFeature
{
    std::uint32_t agent = 0;
    std::uint32_t feature = 0;
};

/// Somebody begins to take on a state.
struct RecalledState
{
    std::uint32_t agent = 0;
    std::uint32_t state = 0;
};

/// What rules may still do in this step; the rest comes in the next one. Counted, not timed, so
/// that it is the same on any machine.
struct StepBudget
{
    std::size_t actions = 0;
    std::size_t heard = 0; ///< events that reach somebody
    std::size_t asked = 0; ///< people of whom a sent event asks whether they are meant
};

struct RuleClock
{
    std::uint64_t step = 0;
    double seconds = 0.0; ///< since the session began
};

struct RuleState
{
    std::vector<ActiveRule> rules; ///< the first matters most
    AgentStates agents;
    ArtistNumbers numbers;
    PlaceRooms places;
    PlaceTurns turns;
    EventQueue events;
    FiringLog log;
    RuleProblems problems;
    model::RelationTable relations;
    model::RelationKinds relationKinds;
    std::uint32_t seed = 1;
    /// Agent with whom a step begins to run actions: to whom it did not come in the step before.
    std::uint32_t firstToRun = 0;
    RuleClock clock;

    // Of this step.
    StepBudget budget;
    PeopleIndex people;
    std::vector<std::uint32_t> travellers; ///< to whom something happened on the way, ascending
    std::vector<EndedClip> endedClips;
    std::vector<RecalledState> recalled;
    std::vector<ChangedFeature> changedFeatures;
};

/// The state and whom it is about; refers to both.
struct RuleScope
{
    RuleState& state;
    RuleHost& host;
};

/// Between 0 and 1: decided by the seed, the individual, how often rules fired for it, the step and
/// the purpose.
[[nodiscard]] float draw(const RuleScope& scope, std::uint32_t agent, std::uint64_t purpose);
/// A message whose %1 is the rule's name.
template<class... Arguments>
[[nodiscard]] Problem problemOf(const RuleState& state, std::uint32_t rule, const char* id,
                                const Arguments&... arguments)
{
    const model::Rule& data = state.rules[rule].data;
    return {{id, data.name, arguments...}, data.id};
}
/// `rule` (kNoRule: none) has come to more than a step has room for.
void reportOverload(RuleState& state, std::uint32_t rule);
/// How many have taken the places, as of now.
[[nodiscard]] PlaceRooms& countedPlaces(const RuleScope& scope);
/// A place counts him as its guest from now on; 0: none does.
void holdPlace(RuleState& state, std::uint32_t agent, model::PlaceId place);

} // namespace crowd::behavior
