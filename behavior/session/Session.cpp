// SPDX-License-Identifier: MIT
#include "behavior/session/Session.h"

#include <algorithm>
#include <cmath>

#include "behavior/crowd/Chunks.h"
#include "behavior/crowd/ForceKernel.h"
#include "model/base/Random.h"

namespace crowd::behavior {

namespace {

constexpr std::uint32_t kNobody = 0xFFFFFFFFU;
constexpr float kBodyRadius = 0.25F;
constexpr float kFastest = 10.0F;
constexpr float kTurnRadiansPerSecond = 4.0F;
constexpr float kTurnsAbove = 0.15F; ///< m/s: below, nobody turns to where he is pushed
constexpr float kSpeedSmoothing = 0.15F;
constexpr float kPi = 3.14159265F;

/// Heading after turning towards a direction as far as a body can in one step.
float turned(float heading, float velocityX, float velocityZ)
{
    float turn = std::remainder(std::atan2(velocityX, velocityZ) - heading, 2.0F * kPi);
    const float most = kTurnRadiansPerSecond * Session::kStepSeconds;
    turn = std::clamp(turn, -most, most);
    return std::remainder(heading + turn, 2.0F * kPi);
}

} // namespace

Session::Session(const model::Scene& scene, const SessionPlan& plan)
    : m_population(scene.population),
      m_templates(std::make_shared<const std::vector<model::TemplateEntry>>(scene.templates)),
      m_seed(scene.seed)
{
    for (const model::TemplateEntry& entry : *m_templates) {
        m_gaits.emplace_back(entry);
    }
    m_warnings = m_follower.setPaths(plan.places, plan.paths);
    addWalkers(plan);
    addBodies(plan);
}

void Session::addWalkers(const SessionPlan& plan)
{
    std::vector<SessionPlan::Walker> walkers = plan.walkers;
    std::ranges::stable_sort(walkers, {}, &SessionPlan::Walker::id);
    m_walkerOfAgent.assign(m_population.size(), kNobody);
    std::vector<PathFollower::Assignment> assignments;
    std::size_t missing = 0;
    for (const SessionPlan::Walker& walker : walkers) {
        const std::size_t row = m_population.rowOf(walker.id);
        if (row == model::Population::npos || m_walkerOfAgent[row] != kNobody) {
            ++missing;
            continue;
        }
        const auto entry =
            std::ranges::find(*m_templates, m_population.column(model::columns::templateId)[row],
                              &model::TemplateEntry::id);
        Shown shown;
        shown.row = static_cast<std::uint32_t>(row);
        shown.table = static_cast<std::uint32_t>(entry - m_templates->begin());
        shown.heading = m_population.column(model::columns::heading)[row];
        shown.height = m_population.column(model::columns::height)[row];
        shown.place = static_cast<double>(m_population.column(model::columns::phase)[row]);
        m_walkerOfAgent[row] = static_cast<std::uint32_t>(m_shown.size());
        m_ids.push_back(walker.id);
        m_shown.push_back(shown);
        const bool isSpeed = std::isfinite(walker.metresPerSecond);
        m_wantedSpeed.push_back(isSpeed ? std::clamp(walker.metresPerSecond, 0.0F, kFastest)
                                        : 1.3F);
        assignments.push_back(
            {static_cast<std::uint32_t>(row), walker.path, model::hashKeys(m_seed, walker.id, 31)});
    }
    if (missing > 0) {
        m_warnings.push_back("Walkers that are not in the scene, or named twice. Left out: " +
                             std::to_string(missing) + ".");
    }
    for (std::string& problem : m_follower.assign(assignments, m_population.size())) {
        m_warnings.push_back(std::move(problem));
    }
}

void Session::addBodies(const SessionPlan& plan)
{
    const auto positions = m_population.column(model::columns::position);
    const auto girths = m_population.column(model::columns::girth);
    std::vector<AgentState> bodies(m_population.size());
    bool hasLevels = false;
    for (std::size_t row = 0; row < bodies.size(); ++row) {
        const bool walks = m_walkerOfAgent[row] != kNobody &&
                           m_follower.isWalking(static_cast<std::uint32_t>(row));
        bodies[row].position = {positions[row].x, positions[row].z};
        bodies[row].groundHeight = positions[row].y;
        bodies[row].radius = kBodyRadius * std::clamp(girths[row], 0.2F, 4.0F);
        bodies[row].preferredSpeed = walks ? m_wantedSpeed[m_walkerOfAgent[row]] : 0.0F;
        hasLevels = hasLevels || std::fabs(positions[row].y - positions[0].y) > kLevelMetres;
    }
    m_crowd.parameters.slowing = 1.0F;
    m_crowd.setLevels(hasLevels);
    m_crowd.setWalls(plan.walls);
    m_crowd.setAgents(bodies);
    for (Shown& shown : m_shown) {
        shown.position = positions[shown.row];
    }
}

void Session::step()
{
    m_follower.steer(m_crowd);
    m_crowd.step(kStepSeconds);
    ++m_steps;
    overRows(m_crowd.size(), [this](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            show(row);
        }
    });
}

/// Body, heading and gait of the agent in a row of the crowd, if it is a walker.
void Session::show(std::size_t row)
{
    const AgentColumns& agents = m_crowd.columns();
    const std::uint32_t walker = m_walkerOfAgent[agents.agent[row]];
    if (walker == kNobody) {
        return;
    }
    Shown& shown = m_shown[walker];
    const float velocityX = agents.velocityX[row];
    const float velocityZ = agents.velocityZ[row];
    const float speed = std::sqrt(velocityX * velocityX + velocityZ * velocityZ);
    shown.position = {agents.x[row], agents.y[row], agents.z[row]};
    shown.speed += (speed - shown.speed) * kSpeedSmoothing;
    if (speed > kTurnsAbove) {
        shown.heading = turned(shown.heading, velocityX, velocityZ);
    }
    if (shown.table >= m_gaits.size() || m_gaits[shown.table].isEmpty()) {
        return;
    }
    const GaitTable& table = m_gaits[shown.table];
    shown.gait = static_cast<std::uint32_t>(table.choose(shown.gait, shown.speed));
    const GaitTable::Gait& gait = table.gait(shown.gait);
    if (gait.seconds > 0.0F) {
        const float rate = GaitTable::playback(gait, shown.speed, shown.height);
        shown.place += static_cast<double>(rate * kStepSeconds) / static_cast<double>(gait.seconds);
        shown.place -= std::floor(shown.place);
    }
}

model::CrowdFramePtr Session::frame()
{
    std::vector<glm::vec3> positions;
    std::vector<float> headings;
    std::vector<std::uint16_t> clips;
    std::vector<float> phases;
    std::vector<float> rates;
    const auto clipColumn = m_population.column(model::columns::clip);
    const auto phaseColumn = m_population.column(model::columns::phase);
    const auto rateColumn = m_population.column(model::columns::playbackSpeed);
    for (const Shown& shown : m_shown) {
        positions.push_back(shown.position);
        headings.push_back(shown.heading);
        if (m_steps == 0 || shown.table >= m_gaits.size() || m_gaits[shown.table].isEmpty()) {
            clips.push_back(clipColumn[shown.row]);
            phases.push_back(phaseColumn[shown.row]);
            rates.push_back(rateColumn[shown.row]);
            continue;
        }
        const GaitTable::Gait& gait = m_gaits[shown.table].gait(shown.gait);
        const float rate = GaitTable::playback(gait, shown.speed, shown.height);
        // The reader adds the time that has passed at this rate; take it off here.
        const double passed = gait.seconds > 0.0F ? seconds() * static_cast<double>(rate) /
                                                        static_cast<double>(gait.seconds)
                                                  : 0.0;
        const double phase = shown.place - passed;
        clips.push_back(gait.clip);
        phases.push_back(static_cast<float>(phase - std::floor(phase)));
        rates.push_back(rate);
    }
    if (!m_ids.empty()) {
        m_population.setValues<glm::vec3>(model::columns::position, m_ids, positions);
        m_population.setValues<float>(model::columns::heading, m_ids, headings);
        m_population.setValues<std::uint16_t>(model::columns::clip, m_ids, clips);
        m_population.setValues<float>(model::columns::phase, m_ids, phases);
        m_population.setValues<float>(model::columns::playbackSpeed, m_ids, rates);
    }
    return std::make_shared<const model::CrowdFrame>(
        model::CrowdFrame{m_population, m_templates, seconds()});
}

} // namespace crowd::behavior
