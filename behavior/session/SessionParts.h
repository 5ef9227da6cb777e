// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "behavior/agents/AgentColumns.h"
#include "behavior/agents/AgentUpdate.h"
#include "behavior/agents/ClipAnimation.h"
#include "behavior/agents/GroundContact.h"
#include "behavior/agents/IdleClips.h"
#include "behavior/agents/ParkedDetours.h"
#include "behavior/agents/PropertyOverrides.h"
#include "behavior/agents/RecalledValues.h"
#include "behavior/agents/Seating.h"
#include "behavior/agents/SessionClock.h"
#include "behavior/agents/StateFades.h"
#include "behavior/agents/TemplateTables.h"
#include "behavior/agents/Walkers.h"
#include "behavior/crowd/CrowdSimulation.h"
#include "behavior/motion/PathFollower.h"
#include "behavior/rules/RuleEngine.h"
#include "behavior/session/Companions.h"
#include "behavior/session/SessionPlan.h"
#include "behavior/session/SessionProblems.h"
#include "behavior/session/SessionTimeline.h"
#include "behavior/surface/WalkSurface.h"
#include "model/scene/LightCue.h"
#include "model/scene/Scene.h"

namespace crowd::behavior {

/// A rule wants somebody to take on a state.
struct RuleRecall
{
    model::IndividualId id = 0;
    model::actions::TakeOnState action;
};

/// A rule wants somebody to bear a value of a feature.
struct RuleFeature
{
    model::IndividualId id = 0;
    model::FeatureId feature = 0;
};

/// Somebody will begin to take on a state, seconds.
struct DueRecall
{
    double begin = 0.0;
    model::IndividualId id = 0;
    model::StateId state = 0;
};

/// What a session consists of: what it has read of the scene, the state of its agents in columns,
/// and components that each do one thing over them. Components refer to each other: neither copied
/// nor moved. Row i of the population is agent i.
struct SessionParts
{
    explicit SessionParts(const model::Scene& scene, const SessionPlan& plan);
    SessionParts(const SessionParts&) = delete;
    SessionParts& operator=(const SessionParts&) = delete;

    /// Reads an agent's columns from a row of people, which is the population or replaces it.
    void initAgent(const model::Population& people, std::uint32_t row);
    /// Gives the crowd bodies anew, once agents without a position have left.
    void resetBodies(const model::Population& people);
    /// Walls anew, from the plan, the surface and the places.
    void resetWalls();
    /// Who walks with whom, and who is not seen.
    void adoptGroups(const model::Scene& scene);
    /// Says anew what is wrong with where people are to walk.
    void checkWays();
    /// Who has a tag in this session.
    [[nodiscard]] std::vector<model::IndividualId> tagged(std::uint8_t tag) const;
    /// An agent leaves the scene.
    void leave(std::uint32_t agent);

    // Of the scene.
    model::Scene lastScene; ///< as it was when the session last looked
    /// Its people, with what states and features have made of them here alone.
    model::Population population;
    std::vector<model::Place> places;
    std::vector<model::Path> paths;
    std::vector<model::GroupId> hiddenGroups; ///< ascending
    std::vector<Wall> plannedWalls;
    std::shared_ptr<const WalkSurface> surface; ///< null: open ground
    TemplateTables templates;
    // Of the run.
    SessionClock clock;
    SessionProblems problems;
    DueMarks marks;
    AgentColumns agents;
    PropertyOverrides overrides;
    RecalledValues recalled;
    StateFades fades;
    CrowdSimulation crowd;
    PathFollower follower;
    RuleEngine rules;
    Walkers walkers;
    IdleClips idle;
    ClipAnimation animation;
    Seating seating;
    GroundContact ground;
    ParkedDetours detours;
    Companions companions;
    AgentUpdate update;
    std::vector<RuleRecall> ruleRecalls;               ///< of this step
    std::vector<RuleFeature> ruleFeatures;             ///< of this step
    std::vector<DueRecall> dueRecalls;                 ///< that rules will hear of
    std::shared_ptr<const model::LightCues> lightCues; ///< null: none was told anything
    // As of the last step.
    std::shared_ptr<const OverrideColumns> shownOverrides;
    std::shared_ptr<const std::vector<OwnNumber>> shownNumbers;

private:
    void dismissWithoutPosition();
};

} // namespace crowd::behavior
