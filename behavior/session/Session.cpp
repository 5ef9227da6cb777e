// SPDX-License-Identifier: MIT
#include "behavior/session/Session.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "behavior/crowd/Chunks.h"
#include "behavior/crowd/ForceKernel.h"
#include "behavior/surface/WalkSurface.h"
#include "model/base/Random.h"
#include "model/brush/ClipChoice.h"

namespace crowd::behavior {

namespace {

constexpr float kPersonReach = 0.25F;    ///< metres
constexpr float kGroupSpread = 0.35F;    ///< metres times the root of its size
constexpr float kSpeedSmoothing = 0.15F; ///< in 1/30 s
constexpr float kRampShare = 0.25F;      ///< of the way to the ground's height, in 1/30 s
constexpr int kObstacleSides = 12;
constexpr float kExitMetres = 0.5F; ///< who is so near to an exit is through
constexpr float kFieldReach = 3.0F; ///< of an attractor or repeller, times its radius

/// One of those that can be.
std::uint32_t stepsOf(const model::Scene& scene)
{
    const auto found = std::ranges::find(model::kStepRates, scene.stepsPerSecond);
    return found == model::kStepRates.end() ? model::kStepRates.front() : *found;
}

} // namespace

float Session::shareInStep(float share) const
{
    return m_stepsPerSecond == 30 ? share : 1.0F - std::pow(1.0F - share, 30.0F * m_stepSeconds);
}

SessionPlan SessionPlan::of(const model::Scene& scene)
{
    SessionPlan plan;
    plan.places = scene.places;
    plan.paths = scene.paths;
    return plan;
}

Session::Session(const model::Scene& scene, const SessionPlan& plan)
    : m_population(scene.population), m_places(plan.places), m_paths(plan.paths),
      m_stages(scene.stages), m_seed(scene.seed), m_stepsPerSecond(stepsOf(scene)),
      m_stepSeconds(1.0F / static_cast<float>(m_stepsPerSecond)),
      m_smoothing(shareInStep(kSpeedSmoothing)), m_rampShare(shareInStep(kRampShare))
{
    if (m_stepsPerSecond != scene.stepsPerSecond) {
        warn({"There cannot be " + std::to_string(scene.stepsPerSecond) +
              " steps a second; there are as many as usual. Choose a length in the menu Play."});
    }
    m_rules.setStepsPerSecond(m_stepsPerSecond);
    m_plannedWalls = plan.walls;
    readTemplates(scene);
    for (Problem& problem : m_follower.setPaths(m_places, m_paths)) {
        warn(std::move(problem));
    }
    countGroups(m_population);
    addPeople(plan);
    m_follower.setGroups(m_population.column(model::columns::group));
    leaveOutWhoIsNowhere();
    addBodies(m_population);
    setWalls(m_places);
    m_rules.setRules(scene);
    m_rules.setPeople(m_population, std::vector<std::uint32_t>(m_population.size(), kNoAgent));
}

Session::~Session() = default;

void Session::readTemplates(const model::Scene& scene)
{
    m_templates = std::make_shared<const std::vector<model::TemplateEntry>>(scene.templates);
    m_gaits.clear();
    m_clips.clear();
    m_facts.clear();
    for (const model::TemplateEntry& entry : *m_templates) {
        m_facts.push_back({entry.asset ? entry.asset->footprint : model::Footprint{},
                           model::usualWalkingSpeed(entry)});
        const GaitTable& gaits = m_gaits.emplace_back(entry);
        std::vector<ClipFacts>& facts = m_clips.emplace_back(entry.clipNames.size());
        for (std::size_t i = 0; i < facts.size() && entry.asset; ++i) {
            const int index = entry.asset->clipIndex(entry.clipNames[i]);
            if (index >= 0) {
                const model::Clip& clip = entry.asset->clips[static_cast<std::size_t>(index)];
                facts[i] = {clip.seconds, clip.loop, gaits.isMover(i)};
            }
        }
    }
}

float Session::paceOf(const model::Population& people, std::size_t row) const
{
    const float speed = people.column(model::columns::walkSpeed)[row];
    if (std::isfinite(speed) && speed > 0.0F) {
        return std::min(speed, model::kMaxWalkingSpeed);
    }
    const std::size_t table = tableOf(people, row);
    const float usual =
        table < m_facts.size() ? m_facts[table].usualSpeed : model::kUsualWalkingSpeed;
    const float height = std::max(people.column(model::columns::height)[row], 0.05F);
    const float u = model::unitFloat(model::hashKeys(m_seed, people.ids()[row], 33));
    // Nobody walks like his neighbour.
    return std::min(usual * height * (0.85F + 0.3F * u), model::kMaxWalkingSpeed);
}

PathFollower::Assignment Session::walkOf(const model::Population& people, std::size_t row) const
{
    const model::IndividualId who = people.ids()[row];
    PathFollower::Assignment walk{static_cast<std::uint32_t>(row),
                                  people.column(model::columns::path)[row],
                                  model::hashKeys(m_seed, who, 31),
                                  paceOf(people, row),
                                  model::hashKeys(m_seed, who, 32),
                                  0.0F,
                                  people.column(model::columns::position)[row]};
    const std::uint32_t group = people.column(model::columns::group)[row];
    const auto size = m_groupSizes.find(group);
    if (group != 0 && size != m_groupSizes.end() && size->second > 1) {
        // To the same point as the others, a little beside it.
        walk.seed = model::hashKeys(m_seed, group, 34);
        const std::size_t table = tableOf(people, row);
        const float reach = table < m_facts.size() ? m_facts[table].footprint.reach() : 0.0F;
        const float girth = people.column(model::columns::girth)[row];
        walk.spread = kGroupSpread * std::sqrt(static_cast<float>(size->second)) *
                      std::clamp(reach * girth / kPersonReach, 1.0F, 10.0F);
    }
    return walk;
}

/// Gait that somebody moves with at any speed, 0 for what fits.
std::uint32_t Session::styleOf(const model::Population& people, std::size_t row,
                               std::uint32_t table) const
{
    const std::uint16_t style = people.column(model::columns::walkStyle)[row];
    return style == 0 || table >= m_gaits.size()
               ? 0
               : static_cast<std::uint32_t>(m_gaits[table].gaitOf(style - 1U));
}

/// Of somebody's template; as many as there are for one that is none of them.
std::uint32_t Session::tableOf(const model::Population& people, std::size_t row) const
{
    const auto entry = std::ranges::find(
        *m_templates, people.column(model::columns::templateId)[row], &model::TemplateEntry::id);
    return static_cast<std::uint32_t>(entry - m_templates->begin());
}

const model::Footprint& Session::footprintOf(std::size_t agent) const
{
    static const model::Footprint kPerson;
    const std::uint32_t table = m_shown[agent].table;
    return table < m_facts.size() ? m_facts[table].footprint : kPerson;
}

Session::Shown Session::shownFrom(const model::Population& people, std::size_t row) const
{
    Shown shown;
    shown.table = tableOf(people, row);
    shown.height = people.column(model::columns::height)[row];
    shown.style = styleOf(people, row, shown.table);
    shown.seat = people.column(model::columns::seat)[row];
    return shown;
}

void Session::setMotion(const model::Population& people, std::uint32_t row)
{
    m_motion.put(row, people.column(model::columns::position)[row]);
    m_motion.heading[row] = people.column(model::columns::heading)[row];
    const float phase = people.column(model::columns::phase)[row];
    m_motion.gaitPlace[row] = phase - std::floor(phase);
    markDirty(row);
}

void Session::countGroups(const model::Population& people)
{
    m_groupSizes.clear();
    for (const std::uint32_t group : people.column(model::columns::group)) {
        ++m_groupSizes[group];
    }
}

void Session::addPeople(const SessionPlan& plan)
{
    std::vector<PathFollower::Assignment> assignments;
    m_motion.assign(m_population.size());
    for (std::uint32_t row = 0; row < m_population.size(); ++row) {
        m_shown.push_back(shownFrom(m_population, row));
        setMotion(m_population, row);
        const PathFollower::Assignment walk = walkOf(m_population, row);
        if (walk.path != 0 && plan.walkers.empty()) {
            assignments.push_back(walk);
        }
    }
    std::size_t missing = 0;
    std::vector<bool> isTaken(m_population.size(), false);
    for (const SessionPlan::Walker& walker : plan.walkers) {
        const std::size_t row = m_population.rowOf(walker.id);
        if (row == model::Population::npos || isTaken[row]) {
            ++missing;
            continue;
        }
        isTaken[row] = true;
        const float pace = std::isfinite(walker.metresPerSecond)
                               ? std::clamp(walker.metresPerSecond, 0.0F, model::kMaxWalkingSpeed)
                               : model::kUsualWalkingSpeed;
        PathFollower::Assignment walk{static_cast<std::uint32_t>(row), walker.path,
                                      model::hashKeys(m_seed, walker.id, 31), pace};
        walk.from = m_motion.position(row);
        assignments.push_back(walk);
    }
    if (missing > 0) {
        warn({"Walkers that are not in the scene, or named twice. Left out: " +
              std::to_string(missing) + "."});
    }
    for (Problem& problem : m_follower.assign(assignments, m_population.size())) {
        warn(std::move(problem));
    }
    for (std::size_t row = 0; row < m_population.size() && plan.walkers.empty(); ++row) {
        m_follower.setPace(static_cast<std::uint32_t>(row), paceOf(m_population, row));
    }
}

/// Bodies anew from where people are shown; who moves keeps his velocity.
void Session::addBodies(const model::Population& people)
{
    const auto girths = people.column(model::columns::girth);
    std::vector<AgentState> bodies(people.size());
    std::vector<LongBody> longBodies;
    bool hasLevels = m_surface != nullptr;
    for (std::size_t row = 0; row < bodies.size(); ++row) {
        bodies[row].position = {m_motion.x[row], m_motion.z[row]};
        bodies[row].groundHeight = m_motion.y[row];
        const model::Footprint& footprint = footprintOf(row);
        const float girth = std::clamp(girths[row], 0.05F, 20.0F);
        bodies[row].radius = footprint.radius * girth;
        if (footprint.front > 0.0F || footprint.back > 0.0F) {
            longBodies.push_back(
                {static_cast<std::uint32_t>(row), footprint.front * girth, footprint.back * girth});
        }
        bodies[row].preferredSpeed = 0.0F; // until it is steered
        bodies[row].velocity = m_motion.speed[row] * glm::vec2(std::sin(m_motion.heading[row]),
                                                               std::cos(m_motion.heading[row]));
        hasLevels = hasLevels || std::fabs(m_motion.y[row] - m_motion.y.front()) > kLevelMetres;
    }
    m_crowd.setLevels(hasLevels);
    m_crowd.setAgents(bodies, longBodies);
    m_standing.assign(bodies.size(), {});
    turnLongBodies();
}

/// As they are shown.
void Session::turnLongBodies()
{
    for (LongBody& body : m_crowd.longBodies()) {
        const float heading = m_motion.heading[body.agent];
        body.headingX = std::sin(heading);
        body.headingZ = std::cos(heading);
    }
}

void Session::setWalls(const std::vector<model::Place>& places)
{
    std::vector<Wall> walls = m_plannedWalls;
    if (m_surface) {
        walls.insert(walls.end(), m_surface->walls().begin(), m_surface->walls().end());
    }
    for (const model::Place& place : places) {
        for (int side = 0; side < kObstacleSides && place.role == model::PlaceRole::Obstacle;
             ++side) {
            const auto corner = [&](int index) {
                const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(index) /
                                    static_cast<float>(kObstacleSides);
                return glm::vec2(place.position.x, place.position.z) +
                       place.radius * glm::vec2(std::sin(angle), std::cos(angle));
            };
            walls.push_back({corner(side), corner(side + 1), place.position.y - 1.0F,
                             place.position.y + 2.0F, true});
        }
    }
    m_crowd.setWalls(walls);
}

void Session::setSurface(std::shared_ptr<const WalkSurface> surface)
{
    m_surface = std::move(surface);
    m_follower.setSurface(m_surface);
    m_standing.assign(m_shown.size(), {});
    m_crowd.setLevels(m_surface != nullptr);
    setWalls(m_places);
    warnOfWays();
}

void Session::send(const std::string& event, float payload,
                   const std::vector<model::IndividualId>& ids)
{
    if (!std::isfinite(payload)) {
        warn({"Event \"" + event +
              "\" came with a number that is none, and is not sent. Give it another one."});
        return;
    }
    glm::vec3 middle(0.0F);
    std::vector<std::uint32_t> agents;
    for (const model::IndividualId each : ids) {
        const std::size_t row = m_population.rowOf(each);
        if (row != model::Population::npos) {
            agents.push_back(static_cast<std::uint32_t>(row));
            middle += m_motion.position(row);
        }
    }
    middle /= static_cast<float>(std::max<std::size_t>(1, agents.size()));
    for (const std::uint32_t agent : agents) {
        m_rules.send(event, payload, agent, middle);
    }
}

void Session::sendTagged(const std::string& event, float payload, std::uint8_t tag)
{
    std::vector<model::IndividualId> ids;
    for (std::uint32_t agent = 0; agent < m_shown.size(); ++agent) {
        if ((m_rules.tags(agent) >> tag & 1U) != 0) {
            ids.push_back(m_population.ids()[agent]);
        }
    }
    send(event, payload, ids);
}

void Session::step()
{
    m_follower.steer(m_crowd);
    m_rules.step(*this, m_steps);
    actPlaces();
    goAroundParked();
    brake();
    turnLongBodies();
    m_crowd.step(m_stepSeconds);
    ++m_steps;
    const std::vector<std::uint32_t> sitters = m_sitters;
    for (const std::uint32_t agent : sitters) {
        settle(agent);
    }
    showAll();
    publishLooks();
    m_ownNumbers = m_rules.ownNumbers();
    if (m_steps % m_stepsPerSecond == 0) {
        warnOfCrowding();
    }
}

/// Attractors, repellers and exits.
void Session::actPlaces()
{
    const std::span<Body> bodies = m_crowd.bodies();
    for (const model::Place& place : m_places) {
        const bool isField =
            place.role == model::PlaceRole::Attractor || place.role == model::PlaceRole::Repeller;
        if (!isField && place.role != model::PlaceRole::Exit) {
            continue;
        }
        const float reach = isField ? place.radius * kFieldReach : place.radius + kExitMetres;
        const float sign = place.role == model::PlaceRole::Attractor ? 1.0F : -1.0F;
        for (std::uint32_t agent = 0; agent < bodies.size(); ++agent) {
            Body& body = bodies[agent];
            const glm::vec2 way(place.position.x - body.x, place.position.z - body.z);
            const float away = std::sqrt(way.x * way.x + way.y * way.y);
            if (away > reach || body.preferredSpeed <= 0.0F || m_shown[agent].isGone) {
                continue;
            }
            if (!isField) {
                leave(agent);
                continue;
            }
            const float pull =
                sign * body.preferredSpeed * (1.0F - away / reach) / std::max(away, 0.1F);
            body.desiredX += way.x * pull;
            body.desiredZ += way.y * pull;
        }
    }
}

} // namespace crowd::behavior
