// SPDX-License-Identifier: MIT
#include "behavior/session/Session.h"

#include <algorithm>
#include <cmath>

#include "behavior/agents/CrowdBodies.h"
#include "behavior/agents/PlaceEffects.h"
#include "behavior/session/PlanChecks.h"
#include "behavior/session/PoseCapture.h"
#include "behavior/session/SceneAdoption.h"
#include "behavior/session/SceneFeatures.h"
#include "behavior/session/SceneRecall.h"
#include "behavior/session/SessionBeginning.h"
#include "behavior/session/SessionParts.h"
#include "behavior/session/SessionRules.h"

namespace crowd::behavior {

Session::Session(const model::Scene& scene, const SessionPlan& plan)
    : m_parts(std::make_unique<SessionParts>(scene, plan)),
      m_ruleHost(std::make_unique<SessionRules>(*m_parts))
{
    SessionParts& parts = *m_parts;
    if (parts.clock.stepsPerSecond != scene.stepsPerSecond) {
        parts.problems.add(
            {{QT_TRANSLATE_NOOP("Messages", "There cannot be %1 steps a second; there are as many "
                                            "as usual. Choose a length in the menu Play."),
              scene.stepsPerSecond}});
    }
    for (Problem& problem : parts.follower.setPaths(parts.places, parts.paths)) {
        parts.problems.add(std::move(problem));
    }
    parts.walkers.setParties(scene.parties());
    parts.companions.read(scene);
    if (plan.walkers.empty()) {
        assignWalkers();
    } else {
        assignPlanned(plan);
    }
    parts.adoptGroups(scene);
    parts.marks.read(scene.timeline);
    parts.resetBodies(parts.population);
    parts.resetWalls();
    parts.rules.setStepsPerSecond(parts.clock.stepsPerSecond);
    parts.rules.setRules(scene);
    parts.rules.setPeople(parts.population,
                          std::vector<std::uint32_t>(parts.population.size(), kNoAgent));
}

Session::~Session() = default;

/// As the population says.
void Session::assignWalkers()
{
    SessionParts& parts = *m_parts;
    const model::Population& people = parts.population;
    std::vector<PathFollower::Assignment> assignments;
    for (std::size_t row = 0; row < people.size(); ++row) {
        const PathFollower::Assignment walk = parts.walkers.assignmentOf(people, row);
        if (walk.path != 0) {
            assignments.push_back(walk);
        }
    }
    for (Problem& problem : parts.follower.assign(assignments, people.size())) {
        parts.problems.add(std::move(problem));
    }
    for (std::uint32_t row = 0; row < people.size(); ++row) {
        parts.follower.setPace(row, parts.walkers.paceOf(people, row));
    }
}

/// As the plan says; the population's paths count for nobody.
void Session::assignPlanned(const SessionPlan& plan)
{
    SessionParts& parts = *m_parts;
    const model::Population& people = parts.population;
    std::vector<PathFollower::Assignment> assignments;
    std::size_t missing = 0;
    std::vector<bool> isTaken(people.size(), false);
    for (const SessionPlan::Walker& walker : plan.walkers) {
        const std::size_t row = people.rowOf(walker.id);
        if (row == model::Population::npos || isTaken[row]) {
            ++missing;
            continue;
        }
        isTaken[row] = true;
        const float pace = std::isfinite(walker.metresPerSecond)
                               ? std::clamp(walker.metresPerSecond, 0.0F, model::kMaxWalkingSpeed)
                               : model::kUsualWalkingSpeed;
        PathFollower::Assignment walk =
            parts.walkers.assignmentTo(walker.id, row, walker.path, pace);
        walk.from = parts.agents.motion.position(row);
        assignments.push_back(walk);
    }
    if (missing > 0) {
        parts.problems.add(
            {{QT_TRANSLATE_NOOP("Messages",
                                "Walkers that are not in the scene, or named twice. Left out: %1."),
              missing}});
    }
    for (Problem& problem : parts.follower.assign(assignments, people.size())) {
        parts.problems.add(std::move(problem));
    }
}

std::uint64_t Session::steps() const
{
    return m_parts->clock.steps;
}

std::uint32_t Session::stepsPerSecond() const
{
    return m_parts->clock.stepsPerSecond;
}

double Session::seconds() const
{
    return m_parts->clock.seconds();
}

void Session::setStart(double seconds)
{
    m_parts->clock.start = seconds;
}

void Session::beginAs(const SessionPose& before, const SessionPose& now)
{
    beginOnTheMove(*m_parts, before, now);
}

void Session::beginFrom(const SessionPose& before, const SessionPose& now)
{
    setStart(now.seconds);
    beginAsIn(*m_parts, now);
    beginOnTheMove(*m_parts, before, now);
}

void Session::adopt(const model::Scene& scene, bool arePosesKept)
{
    adoptScene(*m_parts, scene, arePosesKept);
}

void Session::adopt(const model::Scene& scene, const model::ChangeOver& change)
{
    adoptRecall(*m_parts, scene, change);
}

model::StateRecall Session::recall(const model::ChangeOver& change)
{
    model::StateRecall done = recallInSession(*m_parts, change);
    for (const model::Message& note : done.notes) {
        m_parts->problems.add({note});
    }
    return done;
}

void Session::setSurface(std::shared_ptr<const WalkSurface> surface)
{
    m_parts->surface = std::move(surface);
    m_parts->follower.setSurface(m_parts->surface);
    m_parts->ground.setSurface(m_parts->surface);
    m_parts->crowd.setLevels(m_parts->surface != nullptr);
    m_parts->resetWalls();
    m_parts->checkWays();
}

void Session::send(const std::string& event, float payload,
                   const std::vector<model::IndividualId>& ids)
{
    if (!std::isfinite(payload)) {
        m_parts->problems.add(
            {{QT_TRANSLATE_NOOP("Messages", "Event \"%1\" came with a number that is none, and is "
                                            "not sent. Give it another one."),
              event}});
        return;
    }
    glm::vec3 middle(0.0F);
    std::vector<std::uint32_t> agents;
    for (const model::IndividualId each : ids) {
        const std::size_t row = m_parts->population.rowOf(each);
        if (row != model::Population::npos) {
            agents.push_back(static_cast<std::uint32_t>(row));
            middle += m_parts->agents.motion.position(row);
        }
    }
    middle /= static_cast<float>(std::max<std::size_t>(1, agents.size()));
    for (const std::uint32_t agent : agents) {
        m_parts->rules.send(event, payload, agent, middle);
    }
}

void Session::sendTagged(const std::string& event, float payload, std::uint8_t tag)
{
    send(event, payload, m_parts->tagged(tag));
}

void Session::perform(const model::Mark& mark)
{
    m_parts->marks.forget(mark.id);
    performMark(*this, *m_parts, mark);
}

/// What the timeline has come to.
void Session::performDue()
{
    for (const model::Mark& mark : m_parts->marks.take(m_parts->clock.seconds())) {
        performMark(*this, *m_parts, mark);
    }
}

void Session::step()
{
    performDue();
    SessionParts& parts = *m_parts;
    parts.follower.steer(parts.crowd);
    tellRulesOfRecalls(parts);
    parts.rules.step(*m_ruleHost, parts.clock.steps);
    parts.companions.step(parts, *m_ruleHost);
    if (m_steering) {
        m_steering(parts.crowd);
    }
    for (const std::uint32_t agent :
         applyPlaceEffects(parts.places, parts.crowd.bodies(), parts.agents.isGone)) {
        parts.leave(agent);
    }
    parts.detours.apply(parts.crowd, parts.follower, parts.surface.get());
    parts.update.brake();
    turnLongBodies(parts.crowd, parts.agents.motion);
    parts.crowd.step(parts.clock.stepSeconds);
    ++parts.clock.steps;
    parts.seating.step();
    parts.update.updateAll();
    recallForRules(parts);
    takeOnFeatures(parts);
    parts.shownOverrides = parts.overrides.publish();
    parts.shownNumbers = parts.rules.ownNumbers();
    parts.fades.end(parts.clock.seconds());
    if (parts.clock.steps % parts.clock.stepsPerSecond == 0) {
        warnOfCrowding();
    }
}

/// More people than can stand in a place are sent to it, or have come to the end of a path there.
void Session::warnOfCrowding()
{
    SessionParts& parts = *m_parts;
    GuestCounts guests;
    for (std::uint32_t agent = 0; agent < parts.agents.size(); ++agent) {
        const model::PlaceId held = parts.rules.heldPlace(agent);
        const model::PlaceId place = held != 0 ? held : parts.follower.endPlace(agent);
        if (place != 0 && parts.agents.isGone[agent] == 0) {
            ++guests[place];
        }
    }
    for (Problem& problem : problemsOfCrowding(guests, parts.places, parts.problems.all())) {
        parts.problems.add(std::move(problem));
    }
}

SessionPosePtr Session::pose() const
{
    return capturePose(*m_parts);
}

model::CrowdFramePtr Session::frame() const
{
    return std::make_shared<const model::CrowdFrame>(captureFrame(*m_parts));
}

std::vector<model::PathId> Session::paths() const
{
    std::vector<model::PathId> paths(m_parts->agents.size(), 0);
    for (std::uint32_t agent = 0; agent < paths.size(); ++agent) {
        if (m_parts->agents.isGone[agent] == 0) {
            paths[agent] = m_parts->follower.pathOf(agent);
        }
    }
    return paths;
}

SessionTally Session::tally() const
{
    return countPeople(*m_parts);
}

const std::vector<Problem>& Session::warnings() const
{
    return m_parts->problems.all();
}

std::vector<Problem> Session::problems() const
{
    std::vector<Problem> problems = warnings();
    const std::vector<Problem>& ofRules = m_parts->rules.problems();
    problems.insert(problems.end(), ofRules.begin(), ofRules.end());
    return problems;
}

RuleEngine& Session::rules()
{
    return m_parts->rules;
}

CrowdSimulation& Session::crowd()
{
    return m_parts->crowd;
}

} // namespace crowd::behavior
