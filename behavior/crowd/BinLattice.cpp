// SPDX-License-Identifier: MIT
#include "behavior/crowd/BinLattice.h"

#include <algorithm>
#include <cmath>

#include "behavior/crowd/Chunks.h"

namespace crowd::behavior {

namespace {

struct Box
{
    float lowX = 0.0F;
    float highX = 0.0F;
    float lowZ = 0.0F;
    float highZ = 0.0F;
};

Box boxOf(std::span<const Body> bodies)
{
    Box box{bodies[0].x, bodies[0].x, bodies[0].z, bodies[0].z};
    for (const Body& body : bodies) {
        box.lowX = std::min(box.lowX, body.x);
        box.highX = std::max(box.highX, body.x);
        box.lowZ = std::min(box.lowZ, body.z);
        box.highZ = std::max(box.highZ, body.z);
    }
    return box;
}

/// Bins along a side; a double, since people may be light years apart.
double binsAlong(float low, float high, float binSize)
{
    return std::floor((static_cast<double>(high) - static_cast<double>(low)) /
                      static_cast<double>(binSize)) +
           1.0;
}

constexpr std::size_t kBinsPerAgent = 4;
constexpr std::size_t kFewBins = 4096;

} // namespace

void BinLattice::place(std::span<const Body> bodies, float range)
{
    const Box box = boxOf(bodies);
    const auto most = static_cast<double>(kBinsPerAgent * bodies.size() + kFewBins);
    while (binsAlong(box.lowX, box.highX, range / kAcross) * binsAlong(box.lowZ, box.highZ, range) >
           most) {
        range *= 2.0F;
    }
    m_lowX = box.lowX;
    m_lowZ = box.lowZ;
    m_perMetreX = kAcross / range;
    m_perMetreZ = 1.0F / range;
    m_width = static_cast<std::uint32_t>((box.highX - box.lowX) * m_perMetreX) + 1;
    m_depth = static_cast<std::uint32_t>((box.highZ - box.lowZ) * m_perMetreZ) + 1;
}

/// Counting sort by bin; agents of a bin stay in their order.
void BinLattice::fill(std::span<const Body> bodies)
{
    m_binOfAgent.resize(bodies.size());
    m_binOfRow.resize(bodies.size());
    m_agents.resize(bodies.size());
    overRows(bodies.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t agent = begin; agent < end; ++agent) {
            const auto column =
                static_cast<std::uint32_t>((bodies[agent].x - m_lowX) * m_perMetreX);
            const auto line = static_cast<std::uint32_t>((bodies[agent].z - m_lowZ) * m_perMetreZ);
            m_binOfAgent[agent] = line * m_width + column;
        }
    });
    m_start.assign(std::size_t{m_width} * m_depth + 1, 0);
    for (const std::uint32_t bin : m_binOfAgent) {
        ++m_start[bin];
    }
    std::uint32_t total = 0;
    for (std::uint32_t& start : m_start) {
        total += start;
        start = total;
    }
    // Each entry is the end of its bin now, and its first row when the bin is full.
    for (std::size_t agent = bodies.size(); agent-- > 0;) {
        const std::uint32_t bin = m_binOfAgent[agent];
        const std::uint32_t row = --m_start[bin];
        m_agents[row] = static_cast<std::uint32_t>(agent);
        m_binOfRow[row] = bin;
    }
}

void BinLattice::sort(std::span<const Body> bodies, float range)
{
    if (!bodies.empty()) {
        place(bodies, range);
        fill(bodies);
    }
}

std::size_t BinLattice::bytes() const
{
    return sizeof(std::uint32_t) *
           (m_start.size() + m_binOfAgent.size() + m_binOfRow.size() + m_agents.size());
}

} // namespace crowd::behavior
