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
constexpr int kSeparations = 6;

float tame(float value, float low, float high, float otherwise)
{
    return std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
}

} // namespace

void CrowdSimulation::setAgents(std::span<const AgentState> agents)
{
    m_agents.resize(agents.size());
    for (std::size_t i = 0; i < agents.size(); ++i) {
        const AgentState& state = agents[i];
        m_agents.agent[i] = static_cast<std::uint32_t>(i);
        m_agents.x[i] = tame(state.position.x, -kFarthest, kFarthest, 0.0F);
        m_agents.z[i] = tame(state.position.y, -kFarthest, kFarthest, 0.0F);
        m_agents.y[i] = tame(state.groundHeight, -kFarthest, kFarthest, 0.0F);
        m_agents.velocityX[i] = tame(state.velocity.x, -kFastest, kFastest, 0.0F);
        m_agents.velocityZ[i] = tame(state.velocity.y, -kFastest, kFastest, 0.0F);
        m_agents.desiredX[i] = 0.0F;
        m_agents.desiredZ[i] = 0.0F;
        m_agents.preferredSpeed[i] = tame(state.preferredSpeed, 0.0F, kFastest, 0.0F);
        m_agents.radius[i] = tame(state.radius, 0.01F, kWidest, 0.25F);
    }
}

void CrowdSimulation::setWalls(std::span<const Wall> walls)
{
    m_walls.setWalls(walls, kWallReach);
}

void CrowdSimulation::step(float seconds)
{
    if (!(seconds > 0.0F) || m_agents.size() == 0) {
        return;
    }
    seconds = std::min(seconds, kLongestStep);
    m_lattice.sort(m_agents, m_spare, parameters.range);
    m_isCrowded.resize(m_agents.size());
    const ForceJob job{m_agents,
                       m_lattice,
                       m_walls,
                       parameters,
                       m_spare.desiredX.data(),
                       m_spare.desiredZ.data(),
                       seconds,
                       m_hasLevels,
                       m_spare.x.data(),
                       m_spare.z.data(),
                       m_spare.velocityX.data(),
                       m_spare.velocityZ.data(),
                       m_isCrowded.data()};
    // The other copy's wishes are not needed any more.
    overRows(m_agents.size(), [&](std::size_t begin, std::size_t end) {
        faceRows(m_agents, begin, end, m_spare.desiredX.data(), m_spare.desiredZ.data());
    });
    overRows(m_agents.size(),
             [&](std::size_t begin, std::size_t end) { advanceRows(job, begin, end); });
    std::swap(m_agents.x, m_spare.x);
    std::swap(m_agents.z, m_spare.z);
    std::swap(m_agents.velocityX, m_spare.velocityX);
    std::swap(m_agents.velocityZ, m_spare.velocityZ);
    separate(seconds);
}

/// Bins are those of the step's beginning: nobody has moved further than the range leaves room for.
void CrowdSimulation::separate(float seconds)
{
    for (int i = 0; i < kSeparations; ++i) {
        const ForceJob job{m_agents,          m_lattice,        m_walls, parameters,
                           nullptr,           nullptr,          seconds, m_hasLevels,
                           m_spare.x.data(),  m_spare.z.data(), nullptr, nullptr,
                           m_isCrowded.data()};
        std::atomic<std::size_t> moved{0};
        overRows(m_agents.size(), [&](std::size_t begin, std::size_t end) {
            moved += separateRows(job, begin, end);
        });
        if (moved == 0) {
            break;
        }
        std::swap(m_agents.x, m_spare.x);
        std::swap(m_agents.z, m_spare.z);
    }
}

std::size_t CrowdSimulation::bytes() const
{
    const auto bytesOf = [](const AgentColumns& columns) {
        return columns.agent.size() * sizeof(std::uint32_t) +
               std::size(AgentColumns::kFloats) * (columns.size() + kLanes) * sizeof(float);
    };
    return bytesOf(m_agents) + bytesOf(m_spare) + m_lattice.bytes() + m_isCrowded.size();
}

std::size_t countPairsCloserThan(const CrowdSimulation& crowd, float metres)
{
    AgentColumns agents = crowd.columns();
    AgentColumns spare;
    BinLattice lattice;
    lattice.sort(agents, spare, crowd.parameters.range);
    std::size_t pairs = 0;
    for (std::size_t row = 0; row < agents.size(); ++row) {
        BinLattice::Span spans[3];
        lattice.neighbourhood(lattice.binOfRow(row), spans);
        for (const BinLattice::Span& span : spans) {
            for (std::size_t other = std::max<std::size_t>(span.begin, row + 1); other < span.end;
                 ++other) {
                const float x = agents.x[row] - agents.x[other];
                const float z = agents.z[row] - agents.z[other];
                const bool isOnLevel = std::fabs(agents.y[row] - agents.y[other]) <= kLevelMetres;
                pairs += isOnLevel && x * x + z * z < metres * metres ? 1U : 0U;
            }
        }
    }
    return pairs;
}

} // namespace crowd::behavior
