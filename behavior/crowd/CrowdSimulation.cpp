// SPDX-License-Identifier: MIT
#include "behavior/crowd/CrowdSimulation.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "behavior/crowd/Chunks.h"
#include "behavior/crowd/ForceKernel.h"

namespace crowd::behavior {

namespace {

constexpr float kFarthest = 1e8F;
constexpr float kFastest = 20.0F;
constexpr float kWidest = 2.0F;
constexpr float kLongestStep = 0.1F;
constexpr float kWallReach = 1.5F;
constexpr float kWallRoom = 0.75F; ///< so far from their surface wide bodies notice walls
/// Bodies up to that radius are noticed in good time within the range of the parameters.
constexpr float kUsualWidth = 0.5F;
constexpr int kSeparations = 6;

float tame(float value, float low, float high, float otherwise)
{
    return std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
}

Body bodyOf(const AgentState& state)
{
    return {.x = tame(state.position.x, -kFarthest, kFarthest, 0.0F),
            .z = tame(state.position.y, -kFarthest, kFarthest, 0.0F),
            .velocityX = tame(state.velocity.x, -kFastest, kFastest, 0.0F),
            .velocityZ = tame(state.velocity.y, -kFastest, kFastest, 0.0F),
            .preferredSpeed = tame(state.preferredSpeed, 0.0F, kFastest, 0.0F),
            .radius = tame(state.radius, 0.01F, kWidest, 0.25F)};
}

/// To the larger of both: the same in any order.
void raise(std::atomic<float>& most, float value)
{
    float former = most;
    while (value > former && !most.compare_exchange_weak(former, value)) {
    }
}

} // namespace

void CrowdSimulation::setAgents(std::span<const AgentState> agents,
                                std::span<const LongBody> longBodies)
{
    m_agents = agents.size();
    m_bodies.resize(agents.size());
    m_heights.resize(agents.size() + kLanes);
    m_widest = 0.0F;
    for (std::size_t i = 0; i < agents.size(); ++i) {
        m_bodies[i] = bodyOf(agents[i]);
        m_heights[i] = tame(agents[i].groundHeight, -kFarthest, kFarthest, 0.0F);
        m_widest = std::max(m_widest, m_bodies[i].radius);
    }
    m_longBodies.add(longBodies, m_bodies);
    m_puppets = 0;
    m_heights.resize(m_bodies.size() + kLanes);
    if (std::max(kWallReach, m_widest + kWallRoom) != m_wallReach) {
        layOutWalls();
    }
}

void CrowdSimulation::setPuppets(std::span<const AgentState> puppets)
{
    const std::size_t first = m_bodies.size() - m_puppets;
    m_puppets = puppets.size();
    m_bodies.resize(first + m_puppets);
    m_heights.resize(m_bodies.size() + kLanes);
    const float widest = m_widest;
    for (std::size_t i = 0; i < m_puppets; ++i) {
        Body& body = m_bodies[first + i];
        body = bodyOf(puppets[i]);
        body.preferredSpeed = 0.0F;
        m_heights[first + i] = tame(puppets[i].groundHeight, -kFarthest, kFarthest, 0.0F);
        m_widest = std::max(m_widest, body.radius);
    }
    if (m_widest > widest && std::max(kWallReach, m_widest + kWallRoom) != m_wallReach) {
        layOutWalls();
    }
}

void CrowdSimulation::setWalls(std::span<const Wall> walls)
{
    m_wallList.assign(walls.begin(), walls.end());
    layOutWalls();
}

void CrowdSimulation::layOutWalls()
{
    m_wallReach = std::max(kWallReach, m_widest + kWallRoom);
    m_walls.setWalls(m_wallList, m_wallReach);
}

void CrowdSimulation::step(float seconds)
{
    if (!(seconds > 0.0F) || m_bodies.empty()) {
        return;
    }
    seconds = std::min(seconds, kLongestStep);
    m_longBodies.place(m_bodies, {m_heights.data(), m_bodies.size()});
    const float reach = parameters.range + 2.0F * std::max(m_widest - kUsualWidth, 0.0F);
    m_lattice.sort(m_bodies, reach);
    gather();
    const ForceJob job{.agents = m_rows,
                       .lattice = m_lattice,
                       .walls = m_walls,
                       .parameters = parameters,
                       .seconds = seconds,
                       .reach = reach,
                       .hasLevels = m_hasLevels,
                       .x = m_nextX.data(),
                       .z = m_nextZ.data(),
                       .velocityX = m_velocityX.data(),
                       .velocityZ = m_velocityZ.data(),
                       .slack = m_slack.data()};
    std::atomic<float> aside{0.0F};
    overRows(m_rows.size(), [&](std::size_t begin, std::size_t end) {
        raise(aside, advanceRows(job, begin, end));
    });
    std::swap(m_rows.x, m_nextX);
    std::swap(m_rows.z, m_nextZ);
    separate(job, aside);
    scatter();
    m_longBodies.gather(m_bodies, {m_heights.data(), m_bodies.size()}, m_walls, seconds);
}

void CrowdSimulation::gather()
{
    const std::size_t rows = m_bodies.size();
    const bool hasLongBodies = !m_longBodies.isEmpty();
    m_rows.resize(rows, hasLongBodies);
    m_nextX.resize(rows + kLanes);
    m_nextZ.resize(rows + kLanes);
    m_velocityX.resize(rows + kLanes);
    m_velocityZ.resize(rows + kLanes);
    m_slack.resize(rows + kLanes);
    m_moved.resize(rows);
    m_movedIn.resize(rows / kRowsAtOnce + 1);
    const bool areHeightsNeeded = m_hasLevels || hasLongBodies || !m_walls.isEmpty();
    const std::span<const std::uint32_t> agents = m_lattice.agents();
    overRows(rows, [&](std::size_t begin, std::size_t end) {
        gatherRows(m_bodies.data(), agents.data(), m_rows, begin, end,
                   parameters.plainInstructions);
        for (std::size_t row = begin; row < end && areHeightsNeeded; ++row) {
            m_rows.y[row] = m_heights[agents[row]];
        }
        for (std::size_t row = begin; row < end && hasLongBodies; ++row) {
            m_rows.owner[row] = m_longBodies.owner(agents[row]);
        }
    });
}

/// Bins are those of the step's beginning: nobody has moved further than the range leaves room for.
/// `aside`: how far anybody got away from his former way, whom others have no slack for.
void CrowdSimulation::separate(const ForceJob& before, float aside)
{
    ForceJob job = before;
    job.x = m_nextX.data(); // the columns were swapped
    job.z = m_nextZ.data();
    for (int i = 0; i < kSeparations; ++i) {
        std::atomic<float> furthest{0.0F};
        overRows(m_rows.size(), [&](std::size_t begin, std::size_t end) {
            std::uint32_t* moved = m_moved.data() + begin;
            const Separated separated = separateRows(job, begin, end, aside, moved);
            m_movedIn[begin / kRowsAtOnce] = separated.count;
            raise(furthest, separated.furthest);
        });
        if (furthest == 0.0F) {
            break;
        }
        takeMoved();
        aside += furthest;
    }
}

void CrowdSimulation::takeMoved()
{
    overRows(m_rows.size(), [this](std::size_t begin, std::size_t) {
        for (std::size_t i = 0; i < m_movedIn[begin / kRowsAtOnce]; ++i) {
            const std::uint32_t row = m_moved[begin + i];
            m_rows.x[row] = m_nextX[row];
            m_rows.z[row] = m_nextZ[row];
        }
    });
}

void CrowdSimulation::scatter()
{
    constexpr std::size_t kSoon = 24; // rows that take as long as memory does to answer
    const std::span<const std::uint32_t> agents = m_lattice.agents();
    overRows(m_rows.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            __builtin_prefetch(&m_bodies[agents[std::min(row + kSoon, end - 1)]], 1);
            Body& body = m_bodies[agents[row]];
            body.x = m_rows.x[row];
            body.z = m_rows.z[row];
            body.velocityX = m_velocityX[row];
            body.velocityZ = m_velocityZ[row];
        }
    });
}

std::size_t CrowdSimulation::bytes() const
{
    return m_bodies.size() * (sizeof(Body) + sizeof(float)) + m_rows.bytes() +
           (m_nextX.size() + m_nextZ.size()) * sizeof(float) +
           (m_velocityX.size() + m_velocityZ.size() + m_slack.size()) * sizeof(float) +
           m_moved.size() * sizeof(std::uint32_t) + m_lattice.bytes();
}

std::size_t countPairsCloserThan(const CrowdSimulation& crowd, float metres)
{
    const std::span<const Body> bodies = crowd.bodies();
    BinLattice lattice;
    lattice.sort(bodies, crowd.parameters.range);
    const std::span<const std::uint32_t> agents = lattice.agents();
    std::size_t pairs = 0;
    BinLattice::Line line;
    for (std::size_t row = 0; row < agents.size(); ++row) {
        BinLattice::Span spans[3];
        lattice.neighbourhood(lattice.binOfRow(row), line, spans);
        const Body& self = bodies[agents[row]];
        for (const BinLattice::Span& span : spans) {
            for (std::size_t other = std::max<std::size_t>(span.begin, row + 1); other < span.end;
                 ++other) {
                const float x = self.x - bodies[agents[other]].x;
                const float z = self.z - bodies[agents[other]].z;
                const float above = crowd.heights()[agents[row]] - crowd.heights()[agents[other]];
                const bool isOnLevel = std::fabs(above) <= kLevelMetres;
                pairs += isOnLevel && x * x + z * z < metres * metres ? 1U : 0U;
            }
        }
    }
    return pairs;
}

} // namespace crowd::behavior
