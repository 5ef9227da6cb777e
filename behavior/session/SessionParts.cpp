// SPDX-License-Identifier: MIT
#include "behavior/session/SessionParts.h"

#include <algorithm>
#include <cmath>

#include "behavior/agents/CrowdBodies.h"
#include "behavior/session/PlanChecks.h"
#include "model/base/Bounds.h"

namespace crowd::behavior {

namespace {

namespace partKeys = model::columns;

constexpr float kRampShare = 0.25F; ///< of the way to the ground's height, in 1/30 s

/// One of those that can be.
std::uint32_t stepRateOf(const model::Scene& scene)
{
    const auto found = std::ranges::find(model::kStepRates, scene.stepsPerSecond);
    return found == model::kStepRates.end() ? model::kStepRates.front() : *found;
}

} // namespace

SessionParts::SessionParts(const model::Scene& scene, const SessionPlan& plan)
    : lastScene(scene), population(scene.population), places(plan.places), paths(plan.paths),
      plannedWalls(plan.walls), clock(SessionClock::withSteps(stepRateOf(scene))),
      walkers(templates, scene.seed), idle(population, templates, clock, agents, overrides),
      animation(templates, clock, idle, agents),
      seating(templates, clock, agents, follower, idle, animation),
      ground(agents, crowd, clock.shareInStep(kRampShare)),
      update(population, clock, agents, crowd, ground, animation)
{
    templates.read(scene.templates);
    seating.setStages(scene.stages);
    agents.assign(population.size());
    idle.assign(population.size());
    animation.assign(population.size());
    seating.assign(population.size());
    for (std::uint32_t row = 0; row < population.size(); ++row) {
        initAgent(population, row);
    }
}

void SessionParts::initAgent(const model::Population& people, std::uint32_t row)
{
    const std::uint32_t table = templates.indexOf(people.column(partKeys::templateId)[row]);
    agents.table[row] = table;
    agents.height[row] = people.column(partKeys::height)[row];
    animation.setStyle(row, templates.gaitOfStyle(table, people.column(partKeys::walkStyle)[row]));
    seating.setSeat(row, people.column(partKeys::seat)[row], true);
    agents.motion.put(row, people.column(partKeys::position)[row]);
    agents.motion.heading[row] = people.column(partKeys::heading)[row];
    const float phase = people.column(partKeys::phase)[row];
    agents.motion.gaitPlace[row] = phase - std::floor(phase);
    agents.markDirty(row);
}

void SessionParts::resetBodies(const model::Population& people)
{
    dismissWithoutPosition();
    setBodies(crowd, people, agents, templates, surface != nullptr);
    ground.reset(agents.size());
}

/// A position that is not a number would spread to all others.
void SessionParts::dismissWithoutPosition()
{
    std::size_t lost = 0;
    for (std::uint32_t agent = 0; agent < agents.size(); ++agent) {
        if (!model::Bounds::isPlace(agents.motion.position(agent)) ||
            !std::isfinite(agents.motion.heading[agent])) {
            agents.motion.put(agent, {0.0F, kGoneHeight, 0.0F});
            agents.motion.heading[agent] = 0.0F;
            agents.isGone[agent] = 1;
            agents.activate(agent);
            ++lost;
        }
    }
    if (lost > 0) {
        problems.add(
            {{QT_TRANSLATE_NOOP(
                  "Messages",
                  "Characters without a position, left out: %1. Delete them, or give them one."),
              lost}});
    }
}

void SessionParts::resetWalls()
{
    std::vector<Wall> walls = plannedWalls;
    if (surface) {
        walls.insert(walls.end(), surface->walls().begin(), surface->walls().end());
    }
    addObstacleWalls(places, walls);
    crowd.setWalls(walls);
}

void SessionParts::adoptGroups(const model::Scene& scene)
{
    hiddenGroups = model::groupsThat(scene.groups, &model::Group::isHidden);
    follower.setGroups(scene.parties());
}

void SessionParts::checkWays()
{
    std::vector<Problem> found;
    if (surface) {
        std::vector<model::IndividualId> off;
        for (std::uint32_t agent = 0; agent < agents.size(); ++agent) {
            if (follower.isWalking(agent) && agents.isGone[agent] == 0 &&
                !seating.isSeated(agent) && !surface->isWalkable(agents.motion.position(agent))) {
                off.push_back(population.ids()[agent]);
            }
        }
        found = problemsOfPlaces(places, *surface);
        std::ranges::move(problemsOfPaths(paths, places, *surface), std::back_inserter(found));
        std::ranges::move(problemsOfPeople(std::move(off)), std::back_inserter(found));
    }
    problems.replaceOfWays(std::move(found));
}

std::vector<model::IndividualId> SessionParts::tagged(std::uint8_t tag) const
{
    std::vector<model::IndividualId> ids;
    for (std::uint32_t agent = 0; agent < agents.size(); ++agent) {
        if ((rules.tags(agent) >> tag & 1U) != 0) {
            ids.push_back(population.ids()[agent]);
        }
    }
    return ids;
}

void SessionParts::leave(std::uint32_t agent)
{
    seating.leaveSeat(agent);
    agents.isGone[agent] = 1;
    agents.activate(agent);
    agents.motion.y[agent] = kGoneHeight;
    follower.stop(agent);
    crowd.setLevels(true);
}

} // namespace crowd::behavior
