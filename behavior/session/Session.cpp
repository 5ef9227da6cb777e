// SPDX-License-Identifier: MIT
#include "behavior/session/Session.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <unordered_map>

#include "behavior/crowd/Chunks.h"
#include "behavior/crowd/ForceKernel.h"
#include "behavior/surface/WalkSurface.h"
#include "model/base/Random.h"

namespace crowd::behavior {

namespace {

constexpr float kBodyRadius = 0.25F;
constexpr float kTurnRadiansPerSecond = 4.0F;
constexpr float kTurnsAbove = 0.15F; ///< m/s: below, nobody turns to where he is pushed
constexpr float kMovesAbove = 0.02F;
constexpr float kRunsAbove = 2.0F;       ///< m/s
constexpr float kFastestStride = 12.0F;  ///< m/s: faster is no walk but a jump
constexpr float kGroupSpread = 0.35F;    ///< metres times the root of its size
constexpr float kSpeedSmoothing = 0.15F; ///< in 1/30 s
constexpr float kRampShare = 0.25F;      ///< of the way to the ground's height, in 1/30 s
constexpr int kObstacleSides = 12;
constexpr float kExitMetres = 0.5F; ///< who is so near to an exit is through
constexpr float kFieldReach = 3.0F; ///< of an attractor or repeller, times its radius

bool isSameList(const std::vector<model::TemplateEntry>& a,
                const std::vector<model::TemplateEntry>& b)
{
    return std::ranges::equal(a, b, [](const auto& left, const auto& right) {
        return left.id == right.id && left.asset == right.asset &&
               left.clipNames == right.clipNames &&
               std::ranges::equal(left.clipSpeeds, right.clipSpeeds, [](float x, float y) {
                   return x == y || (std::isnan(x) && std::isnan(y));
               });
    });
}

/// One of those that can be.
std::uint32_t stepsOf(const model::Scene& scene)
{
    const auto found = std::ranges::find(model::kStepRates, scene.stepsPerSecond);
    return found == model::kStepRates.end() ? model::kStepRates.front() : *found;
}

} // namespace

/// Angle after turning towards another one as far as a body can in one step.
float Session::turnedTo(float heading, float target) const
{
    float turn = std::remainder(target - heading, 2.0F * std::numbers::pi_v<float>);
    const float most = kTurnRadiansPerSecond * m_stepSeconds;
    turn = std::clamp(turn, -most, most);
    return std::remainder(heading + turn, 2.0F * std::numbers::pi_v<float>);
}

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
    addBodies();
    setWalls(m_places);
    m_rules.setRules(scene);
    m_rules.setPeople(m_population,
                      std::vector<std::uint32_t>(m_population.size(), PathFollower::kNobody));
}

Session::~Session() = default;

void Session::readTemplates(const model::Scene& scene)
{
    m_templates = std::make_shared<const std::vector<model::TemplateEntry>>(scene.templates);
    m_gaits.clear();
    m_clips.clear();
    for (const model::TemplateEntry& entry : *m_templates) {
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
    const float u = model::unitFloat(model::hashKeys(m_seed, people.ids()[row], 33));
    return model::kUsualWalkingSpeed * (0.85F + 0.3F * u); // nobody walks like his neighbour
}

PathFollower::Assignment Session::walkOf(const model::Population& people, std::size_t row) const
{
    const model::IndividualId who = people.ids()[row];
    PathFollower::Assignment walk{
        static_cast<std::uint32_t>(row),  people.column(model::columns::path)[row],
        model::hashKeys(m_seed, who, 31), paceOf(people, row),
        model::hashKeys(m_seed, who, 32), 0.0F};
    const std::uint32_t group = people.column(model::columns::group)[row];
    const auto size = m_groupSizes.find(group);
    if (group != 0 && size != m_groupSizes.end() && size->second > 1) {
        // To the same point as the others, a little beside it.
        walk.seed = model::hashKeys(m_seed, group, 34);
        walk.spread = kGroupSpread * std::sqrt(static_cast<float>(size->second));
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

Session::Shown Session::shownFrom(const model::Population& people, std::size_t row) const
{
    const auto entry = std::ranges::find(
        *m_templates, people.column(model::columns::templateId)[row], &model::TemplateEntry::id);
    Shown shown;
    shown.table = static_cast<std::uint32_t>(entry - m_templates->begin());
    shown.heading = people.column(model::columns::heading)[row];
    shown.height = people.column(model::columns::height)[row];
    shown.place = static_cast<double>(people.column(model::columns::phase)[row]);
    shown.position = people.column(model::columns::position)[row];
    shown.style = styleOf(people, row, shown.table);
    shown.seat = people.column(model::columns::seat)[row];
    return shown;
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
    for (std::size_t row = 0; row < m_population.size(); ++row) {
        m_shown.push_back(shownFrom(m_population, row));
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
        assignments.push_back({static_cast<std::uint32_t>(row), walker.path,
                               model::hashKeys(m_seed, walker.id, 31), pace});
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
void Session::addBodies()
{
    const auto girths = m_population.column(model::columns::girth);
    std::vector<AgentState> bodies(m_population.size());
    bool hasLevels = m_surface != nullptr;
    for (std::size_t row = 0; row < bodies.size(); ++row) {
        const Shown& shown = m_shown[row];
        bodies[row].position = {shown.position.x, shown.position.z};
        bodies[row].groundHeight = shown.position.y;
        bodies[row].radius = kBodyRadius * std::clamp(girths[row], 0.2F, 4.0F);
        bodies[row].preferredSpeed = 0.0F; // until it is steered
        bodies[row].velocity =
            shown.speed * glm::vec2(std::sin(shown.heading), std::cos(shown.heading));
        hasLevels =
            hasLevels || std::fabs(shown.position.y - m_shown.front().position.y) > kLevelMetres;
    }
    m_crowd.setLevels(hasLevels);
    m_crowd.setAgents(bodies);
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
            walls.push_back(
                {corner(side), corner(side + 1), place.position.y - 1.0F, place.position.y + 2.0F});
        }
    }
    m_crowd.setWalls(walls);
}

void Session::setSurface(std::shared_ptr<const WalkSurface> surface)
{
    m_surface = std::move(surface);
    m_follower.setSurface(m_surface);
    m_crowd.setLevels(m_surface != nullptr);
    setWalls(m_places);
    warnOfPlaces();
    warnOfPaths();
}

void Session::adopt(const model::Scene& scene, bool arePosesKept)
{
    if (!isSameList(*m_templates, scene.templates)) {
        readTemplates(scene);
    }
    adoptPaths(scene);
    countGroups(scene.population);
    if (!std::ranges::equal(m_population.ids(), scene.population.ids())) {
        adoptRows(scene);
    }
    adoptValues(scene, arePosesKept);
    m_population = scene.population;
    m_follower.setGroups(m_population.column(model::columns::group));
    m_stages = scene.stages;
    m_seats.clear(); // read anew when somebody wants one
    publishLooks();
    m_rules.setRules(scene);
    m_ownNumbers = m_rules.ownNumbers();
}

void Session::adoptPaths(const model::Scene& scene)
{
    if (m_places == scene.places && m_paths == scene.paths) {
        return;
    }
    m_places = scene.places;
    m_paths = scene.paths;
    m_warnings = m_follower.setPaths(m_places, m_paths);
    setWalls(m_places);
    warnOfPlaces();
    warnOfPaths();
}

/// People came or went.
void Session::adoptRows(const model::Scene& scene)
{
    const model::Population& people = scene.population;
    std::vector<std::uint32_t> keep(people.size(), PathFollower::kNobody);
    std::vector<Shown> shown(people.size());
    for (std::size_t row = 0; row < people.size(); ++row) {
        const std::size_t former = m_population.rowOf(people.ids()[row]);
        if (former != model::Population::npos) {
            keep[row] = static_cast<std::uint32_t>(former);
            shown[row] = m_shown[former];
        } else {
            shown[row] = shownFrom(people, row);
        }
    }
    m_shown = std::move(shown);
    m_sitters.clear();
    for (std::uint32_t agent = 0; agent < m_shown.size(); ++agent) {
        if (m_shown[agent].sitting == Sitting::Goes || m_shown[agent].sitting == Sitting::Settles) {
            m_sitters.push_back(agent);
        }
    }
    m_follower.rearrange(keep);
    m_rules.setPeople(people, keep);
    for (std::size_t row = 0; row < people.size(); ++row) {
        if (keep[row] == PathFollower::kNobody) {
            const PathFollower::Assignment walk = walkOf(people, row);
            if (walk.path != 0) {
                m_follower.follow(walk);
            }
        }
    }
    // From here on the former values of the rows are those of the same people.
    std::vector<model::IndividualId> gone;
    std::ranges::set_difference(m_population.ids(), people.ids(), std::back_inserter(gone));
    std::vector<model::IndividualId> come;
    std::ranges::set_difference(people.ids(), m_population.ids(), std::back_inserter(come));
    (void)m_population.remove(gone);
    m_population.add(people.rows(come));
    leaveOutWhoIsNowhere();
    addBodies();
}

/// Values that an edit changed since the last look at the scene.
void Session::adoptValues(const model::Scene& scene, bool arePosesKept)
{
    namespace keys = model::columns;
    const model::Population& now = scene.population;
    const auto isOther = [&](const auto& key) {
        return now.columnBytes(key.id).data() != m_population.columnBytes(key.id).data();
    };
    bool hasMoved = false;
    const auto each = [&](const auto& key, const auto& act) {
        if (!isOther(key)) {
            return; // shared: nobody wrote
        }
        const auto before = m_population.column(key);
        const auto after = now.column(key);
        for (std::size_t row = 0; row < after.size(); ++row) {
            if (!(before[row] == after[row])) {
                act(row);
            }
        }
    };
    if (!arePosesKept) {
        each(keys::position, [&](std::size_t row) {
            m_shown[row].position = now.column(keys::position)[row];
            m_shown[row].speed = 0.0F;
            hasMoved = true;
        });
        each(keys::heading,
             [&](std::size_t row) { m_shown[row].heading = now.column(keys::heading)[row]; });
    }
    each(keys::path, [&](std::size_t row) {
        const glm::vec2 at(m_shown[row].position.x, m_shown[row].position.z);
        m_follower.follow(walkOf(now, row), &at);
    });
    each(keys::walkSpeed, [&](std::size_t row) {
        m_follower.setPace(static_cast<std::uint32_t>(row), paceOf(now, row));
    });
    each(keys::tags, [&](std::size_t row) {
        // Only those that the edit is about: rules may have changed others.
        const std::uint64_t after = now.column(keys::tags)[row];
        const std::uint64_t edited = after ^ m_population.column(keys::tags)[row];
        const auto agent = static_cast<std::uint32_t>(row);
        const std::uint64_t tags = (m_rules.tags(agent) & ~edited) | (after & edited);
        m_rules.setTags(agent, tags);
        noteTags(agent, tags);
    });
    each(keys::height, [&](std::size_t row) {
        m_shown[row].height = now.column(keys::height)[row];
        forgetLook(static_cast<std::uint32_t>(row), keys::height.id);
    });
    for (int slot = 0; slot < 8; ++slot) {
        each(keys::tint(slot), [&](std::size_t row) {
            forgetLook(static_cast<std::uint32_t>(row), keys::tint(slot).id);
        });
    }
    each(keys::clip,
         [&](std::size_t row) { forgetLook(static_cast<std::uint32_t>(row), keys::clip.id); });
    each(keys::phase,
         [&](std::size_t row) { forgetLook(static_cast<std::uint32_t>(row), keys::phase.id); });
    each(keys::playbackSpeed, [&](std::size_t row) {
        forgetLook(static_cast<std::uint32_t>(row), keys::playbackSpeed.id);
    });
    each(keys::templateId, [&](std::size_t row) {
        m_shown[row].table = shownFrom(now, row).table;
        m_shown[row].style = styleOf(now, row, m_shown[row].table);
        m_shown[row].gait = 0;
        m_shown[row].order = -1;
        m_shown[row].base = -1;
    });
    each(keys::walkStyle,
         [&](std::size_t row) { m_shown[row].style = styleOf(now, row, m_shown[row].table); });
    each(keys::seat, [&](std::size_t row) {
        if (!arePosesKept) {
            m_shown[row].base = -1;
            m_shown[row].sitting = Sitting::No;
        }
        m_shown[row].seat = now.column(keys::seat)[row];
    });
    if (hasMoved) {
        leaveOutWhoIsNowhere();
        addBodies();
    }
}

void Session::send(const std::string& event, float payload, std::vector<model::IndividualId> ids)
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
            middle += m_shown[row].position;
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
    send(event, payload, std::move(ids));
}

void Session::step()
{
    m_follower.steer(m_crowd);
    m_rules.step(*this, m_steps);
    actPlaces();
    brake();
    m_crowd.step(m_stepSeconds);
    ++m_steps;
    const std::vector<std::uint32_t> sitters = m_sitters;
    for (const std::uint32_t agent : sitters) {
        settle(agent);
    }
    overRows(m_crowd.size(), [this](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            show(row);
        }
    });
    publishLooks();
    m_ownNumbers = m_rules.ownNumbers();
    if (m_steps % m_stepsPerSecond == 0) {
        warnOfCrowding();
    }
}

/// Attractors, repellers and exits.
void Session::actPlaces()
{
    AgentColumns& agents = m_crowd.columns();
    for (const model::Place& place : m_places) {
        const bool isField =
            place.role == model::PlaceRole::Attractor || place.role == model::PlaceRole::Repeller;
        if (!isField && place.role != model::PlaceRole::Exit) {
            continue;
        }
        const float reach = isField ? place.radius * kFieldReach : place.radius + kExitMetres;
        const float sign = place.role == model::PlaceRole::Attractor ? 1.0F : -1.0F;
        for (std::size_t row = 0; row < agents.size(); ++row) {
            const std::uint32_t agent = agents.agent[row];
            const glm::vec2 way(place.position.x - agents.x[row], place.position.z - agents.z[row]);
            const float away = std::sqrt(way.x * way.x + way.y * way.y);
            if (away > reach || agents.preferredSpeed[row] <= 0.0F || m_shown[agent].isGone) {
                continue;
            }
            if (!isField) {
                leave(agent);
                continue;
            }
            const float pull =
                sign * agents.preferredSpeed[row] * (1.0F - away / reach) / std::max(away, 0.1F);
            agents.desiredX[row] += way.x * pull;
            agents.desiredZ[row] += way.y * pull;
        }
    }
}

/// Whoever does not want to go further comes to rest in a step or two rather than at once.
void Session::brake()
{
    AgentColumns& agents = m_crowd.columns();
    overRows(agents.size(), [this, &agents](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            const float speed = std::hypot(agents.velocityX[row], agents.velocityZ[row]);
            const Shown& shown = m_shown[agents.agent[row]];
            if (agents.preferredSpeed[row] != 0.0F || speed < kMovesAbove || shown.isGone ||
                shown.isPut || shown.sitting != Sitting::No || shown.table >= m_gaits.size() ||
                m_gaits[shown.table].isEmpty()) {
                continue;
            }
            const GaitTable::Gait& gait = m_gaits[shown.table].gait(shown.gait);
            agents.preferredSpeed[row] =
                -GaitTable::braking(gait, shown.place, speed, shown.height);
        }
    });
}

const Session::ClipFacts* Session::clipFacts(const Shown& shown, int clip) const
{
    if (shown.table >= m_clips.size() || clip < 0 ||
        static_cast<std::size_t>(clip) >= m_clips[shown.table].size()) {
        return nullptr;
    }
    return &m_clips[shown.table][static_cast<std::size_t>(clip)];
}

/// Body, heading and gait of the agent in a row of the crowd.
void Session::show(std::size_t row)
{
    AgentColumns& agents = m_crowd.columns();
    Shown& shown = m_shown[agents.agent[row]];
    if (shown.isGone) {
        // Out of everybody's way, spread as they were at the beginning.
        const glm::vec3 start = m_population.column(model::columns::position)[agents.agent[row]];
        const bool isSomewhere = model::Bounds::isPlace(start);
        agents.x[row] = isSomewhere ? start.x : 0.0F;
        agents.z[row] = isSomewhere ? start.z : 0.0F;
        agents.y[row] = kGoneHeight;
        return;
    }
    if (shown.isPut || shown.sitting == Sitting::Settles || shown.sitting == Sitting::Sits) {
        agents.x[row] = shown.position.x;
        agents.z[row] = shown.position.z;
        agents.y[row] = shown.position.y;
        agents.velocityX[row] = 0.0F;
        agents.velocityZ[row] = 0.0F;
        shown.isPut = false;
    }
    const float velocityX = agents.velocityX[row];
    const float velocityZ = agents.velocityZ[row];
    const float speed = std::sqrt(velocityX * velocityX + velocityZ * velocityZ);
    shown.isLive = shown.isLive || speed > kMovesAbove || shown.order >= 0 || shown.isTurning ||
                   agents.preferredSpeed[row] > 0.0F;
    if (!shown.isLive) {
        return;
    }
    if (m_surface && agents.preferredSpeed[row] != 0.0F) {
        const float ground = m_surface->height(agents.x[row], agents.z[row], agents.y[row]);
        agents.y[row] += (ground - agents.y[row]) * m_rampShare;
    }
    const glm::vec2 way(agents.x[row] - shown.position.x, agents.z[row] - shown.position.z);
    shown.position = {agents.x[row], agents.y[row], agents.z[row]};
    if (shown.sitting != Sitting::Settles) {
        shown.speed += (speed - shown.speed) * m_smoothing;
    }
    if (speed > kTurnsAbove) {
        shown.heading = turnedTo(shown.heading, std::atan2(velocityX, velocityZ));
        shown.isTurning = false;
    } else if (shown.isTurning) {
        shown.heading = turnedTo(shown.heading, shown.facing);
    }
    const float ahead = way.x * std::sin(shown.heading) + way.y * std::cos(shown.heading);
    shown.stride =
        ahead < kFastestStride * m_stepSeconds ? std::max(ahead / m_stepSeconds, 0.0F) : 0.0F;
    if (const ClipFacts* facts = clipFacts(shown, shown.order)) {
        shown.orderPlace += facts->seconds > 0.0F ? static_cast<double>(m_stepSeconds) /
                                                        static_cast<double>(facts->seconds)
                                                  : 0.0;
        shown.orderPlace = shown.isOrderLooped ? shown.orderPlace - std::floor(shown.orderPlace)
                                               : std::min(shown.orderPlace, 1.0);
        if (shown.isOrderOwn && shown.orderPlace >= 1.0) {
            shown.order = -1;
        }
    }
    followGait(shown, speed, agents.preferredSpeed[row] > 0.0F);
    noteClip(agents.agent[row]);
}

/// Feet set off and come to rest with the body; in between nobody changes his gait for a moment.
void Session::followGait(Shown& shown, float speed, bool wantsOn) const
{
    const float metresPerSecond = !wantsOn          ? speed
                                  : shown.gait == 0 ? std::max(speed, shown.speed)
                                                    : shown.speed;
    if (shown.table >= m_gaits.size() || m_gaits[shown.table].isEmpty()) {
        return;
    }
    const GaitTable& table = m_gaits[shown.table];
    const GaitTable::Gait& former = table.gait(shown.gait);
    const bool stood = shown.gait == 0;
    // Who comes to rest finishes with the walk that he has.
    const bool keepsGait = !wantsOn && !stood && former.metresPerSecond < kRunsAbove;
    const auto chosen = static_cast<std::uint32_t>(
        table.choose(shown.gait, metresPerSecond, keepsGait ? shown.gait : shown.style));
    const GaitTable::Gait& gait = table.gait(chosen);
    if (stood && chosen != 0) {
        shown.place = GaitTable::nearestTogether(gait, shown.place);
        shown.speed = std::max(shown.speed, metresPerSecond);
    }
    if (stood || chosen == 0) {
        shown.gait = chosen;
    } else if (chosen != shown.gait && GaitTable::isAboutToPass(former, shown.place)) {
        shown.place = GaitTable::placeInto(former, gait, shown.place);
        shown.gait = chosen;
    }
    const GaitTable::Gait& present = table.gait(shown.gait);
    if (present.seconds > 0.0F) {
        const float rate = GaitTable::playback(present, shown.stride, shown.height);
        shown.place +=
            static_cast<double>(rate * m_stepSeconds) / static_cast<double>(present.seconds);
        shown.place -= std::floor(shown.place);
    }
}

/// Whether it is another clip than a step ago, so that one goes over into the other.
void Session::noteClip(std::uint32_t agent)
{
    Shown& shown = m_shown[agent];
    const PersonPose pose = poseOf(agent);
    const bool isOfGait =
        shown.gait != 0 && shown.table < m_gaits.size() && !m_gaits[shown.table].isEmpty();
    if (shown.hasLast && shown.last.clip != pose.clip) {
        shown.from = shown.last;
        shown.fromGait = shown.lastGait;
        shown.fadeBegin = seconds();
    }
    goOnFading(shown);
    shown.last = {pose.clip, pose.isLooped, pose.rate, pose.clipSeconds, pose.place};
    shown.lastGait = isOfGait ? shown.gait : 0;
    shown.hasLast = true;
}

/// What is being left goes on too, at the pace of the body where that moved it.
void Session::goOnFading(Shown& shown) const
{
    if (shown.fadeBegin < 0.0 || seconds() - shown.fadeBegin >= kFadeSeconds) {
        return;
    }
    if (shown.fromGait != 0) {
        const GaitTable::Gait& gait = m_gaits[shown.table].gait(shown.fromGait);
        shown.from.rate = GaitTable::playback(gait, shown.stride, shown.height);
    }
    if (shown.from.clipSeconds > 0.0F) {
        shown.from.place += static_cast<double>(m_stepSeconds * shown.from.rate) /
                            static_cast<double>(shown.from.clipSeconds);
    }
}

PersonPose Session::poseOf(std::size_t agent) const
{
    const Shown& shown = m_shown[agent];
    PersonPose pose;
    pose.id = m_population.ids()[agent];
    pose.isGone = shown.isGone;
    pose.from = shown.from;
    pose.fadeBegin = shown.fadeBegin;
    pose.seat = shown.sitting == Sitting::Goes || shown.sitting == Sitting::Settles ? model::kNoSeat
                                                                                    : shown.seat;
    pose.position = shown.position;
    pose.heading = shown.heading;
    const bool hasGaits = shown.table < m_gaits.size() && !m_gaits[shown.table].isEmpty();
    const std::uint32_t gait = hasGaits ? shown.gait : 0;
    if (const ClipFacts* facts = clipFacts(shown, shown.order); facts != nullptr && gait == 0) {
        pose.clip = static_cast<std::uint16_t>(shown.order);
        pose.isLooped = facts->isLooped;
        pose.clipSeconds = facts->seconds;
        pose.place = shown.orderPlace;
        return pose;
    }
    const auto who = static_cast<std::uint32_t>(agent);
    const std::uint16_t own = ownClip(who);
    const ClipFacts* ownFacts = clipFacts(shown, own);
    const bool isMover = ownFacts != nullptr && ownFacts->isMover;
    if (!hasGaits || (gait == 0 && !isMover)) {
        // Standing he does what the scene lets him do.
        pose.clip = own;
        pose.isLooped = ownFacts == nullptr || ownFacts->isLooped;
        pose.clipSeconds = ownFacts == nullptr ? 0.0F : ownFacts->seconds;
        pose.rate = ownRate(who);
        pose.place = ownPlace(who);
        return pose;
    }
    const GaitTable::Gait& chosen = m_gaits[shown.table].gait(gait);
    pose.clip = chosen.clip;
    pose.rate = GaitTable::playback(chosen, shown.stride, shown.height);
    pose.clipSeconds = chosen.seconds;
    pose.place = shown.place;
    return pose;
}

SessionPosePtr Session::pose() const
{
    auto pose = std::make_shared<SessionPose>();
    pose->step = m_steps;
    pose->seconds = seconds();
    pose->hasSeats = m_hasSat;
    pose->looks = m_shownLooks;
    pose->numbers = m_ownNumbers;
    pose->people.reserve(m_shown.size());
    for (std::size_t agent = 0; agent < m_shown.size(); ++agent) {
        if (m_shown[agent].isLive) {
            pose->people.push_back(poseOf(agent));
        }
        if (m_rules.isLit(static_cast<std::uint32_t>(agent))) {
            pose->lit.push_back(m_population.ids()[agent]);
        }
    }
    return pose;
}

model::CrowdFramePtr Session::frame() const
{
    model::CrowdFrame frame{m_population, m_templates, seconds()};
    const SessionPosePtr now = pose();
    applyPose(*now, *now, frame);
    return std::make_shared<const model::CrowdFrame>(std::move(frame));
}

glm::vec3 Session::position(std::uint32_t agent) const
{
    return m_shown[agent].position;
}

model::IndividualId Session::id(std::uint32_t agent) const
{
    return m_population.ids()[agent];
}

model::TemplateId Session::templateOf(std::uint32_t agent) const
{
    return m_population.column(model::columns::templateId)[agent];
}

std::uint32_t Session::group(std::uint32_t agent) const
{
    return m_population.column(model::columns::group)[agent];
}

bool Session::isSeated(std::uint32_t agent) const
{
    const Shown& shown = m_shown[agent];
    return shown.seat != model::kNoSeat &&
           (shown.sitting == Sitting::No || shown.sitting == Sitting::Sits);
}

bool Session::isGone(std::uint32_t agent) const
{
    return m_shown[agent].isGone;
}

model::PathId Session::pathOf(std::uint32_t agent) const
{
    return m_follower.pathOf(agent);
}

std::uint8_t Session::happenings(std::uint32_t agent) const
{
    return m_follower.happenings(agent);
}

model::PlaceId Session::reachedPlace(std::uint32_t agent) const
{
    return m_follower.reachedPlace(agent);
}

float Session::play(std::uint32_t agent, const std::string& clip, bool isLooped)
{
    Shown& shown = m_shown[agent];
    if (shown.table >= m_templates->size()) {
        return -1.0F;
    }
    const std::vector<std::string>& names = (*m_templates)[shown.table].clipNames;
    const auto found = std::ranges::find(names, clip);
    if (found == names.end()) {
        return -1.0F;
    }
    shown.order = static_cast<int>(found - names.begin());
    shown.isOrderLooped = isLooped;
    shown.isOrderOwn = false;
    shown.orderPlace = 0.0;
    shown.isLive = true;
    return std::max(0.1F, clipFacts(shown, shown.order)->seconds);
}

void Session::endClip(std::uint32_t agent)
{
    m_shown[agent].order = -1;
}

bool Session::follow(std::uint32_t agent, model::PathId path)
{
    leaveSeat(agent);
    const glm::vec2 at(m_shown[agent].position.x, m_shown[agent].position.z);
    PathFollower::Assignment walk = walkOf(m_population, agent);
    walk.path = path;
    walk.metresPerSecond = m_follower.pace(agent);
    return m_follower.follow(walk, &at);
}

void Session::sendTo(std::uint32_t agent, const glm::vec3& point)
{
    leaveSeat(agent);
    m_follower.sendTo(agent, point);
}

void Session::stop(std::uint32_t agent)
{
    m_follower.stop(agent);
}

void Session::goOn(std::uint32_t agent)
{
    if (m_follower.pathOf(agent) != 0) {
        leaveSeat(agent);
    }
    m_follower.goOn(agent);
}

void Session::setPace(std::uint32_t agent, float metresPerSecond)
{
    if (std::isfinite(metresPerSecond)) {
        m_follower.setPace(agent, std::clamp(metresPerSecond, 0.0F, model::kMaxWalkingSpeed));
    }
}

void Session::turnTo(std::uint32_t agent, const glm::vec3& point)
{
    Shown& shown = m_shown[agent];
    const glm::vec3 way = point - shown.position;
    if (way.x * way.x + way.z * way.z > 1e-4F) {
        shown.facing = std::atan2(way.x, way.z);
        shown.isTurning = true;
    }
}

void Session::leave(std::uint32_t agent)
{
    leaveSeat(agent);
    m_shown[agent].isGone = true;
    m_shown[agent].isLive = true;
    m_shown[agent].position.y = kGoneHeight;
    m_follower.stop(agent);
    m_crowd.setLevels(true);
}

float Session::speed(std::uint32_t agent) const
{
    return m_shown[agent].speed;
}

void Session::appear(std::uint32_t agent, const glm::vec3& point)
{
    leaveSeat(agent);
    Shown& shown = m_shown[agent];
    shown.isGone = false;
    shown.isLive = true;
    shown.isPut = true;
    shown.hasLast = false;
    shown.fadeBegin = -1.0;
    shown.speed = 0.0F;
    shown.gait = 0;
    shown.position = point;
    if (m_surface) {
        shown.position.y = m_surface->height(point.x, point.z, point.y);
    }
    m_follower.stop(agent);
    m_follower.forgetWay(agent);
}

} // namespace crowd::behavior
