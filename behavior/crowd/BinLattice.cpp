// SPDX-License-Identifier: MIT
#include "behavior/crowd/BinLattice.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

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

Box around(const Box& a, const Box& b)
{
    return {std::min(a.lowX, b.lowX), std::max(a.highX, b.highX), std::min(a.lowZ, b.lowZ),
            std::max(a.highZ, b.highZ)};
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

Box boxAround(std::span<const Body> bodies)
{
    std::vector<Box> boxes(bodies.size() / kRowsAtOnce + 1, boxOf(bodies.first(1)));
    overRows(bodies.size(), [&](std::size_t begin, std::size_t end) {
        boxes[begin / kRowsAtOnce] = boxOf(bodies.subspan(begin, end - begin));
    });
    return std::accumulate(boxes.begin(), boxes.end(), boxes.front(), around);
}

void BinLattice::place(std::span<const Body> bodies, float range)
{
    const Box box = boxAround(bodies);
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

/// Counting sort by bin, first by strips of bins, then within each, so that all cores have
/// something to do and what each does fits its cache. Agents of a bin stay in their order.
void BinLattice::fill(std::span<const Body> bodies)
{
    m_binOfAgent.resize(bodies.size());
    m_binOfRow.resize(bodies.size());
    m_agents.resize(bodies.size());
    m_byStrip.resize(bodies.size());
    const std::size_t bins = std::size_t{m_width} * m_depth;
    m_start.resize(bins + 1);
    m_start[bins] = static_cast<std::uint32_t>(bodies.size());
    const auto inStrips = static_cast<int>(std::bit_width(bins - 1));
    m_stripShift = static_cast<std::uint32_t>(std::max(inStrips - kStripBits, 0));
    countStrips(bodies);
    sortIntoStrips();
    const std::size_t strips = ((bins - 1) >> m_stripShift) + 1;
    const std::size_t inEach = bodies.size() / strips + 1;
    overItems(strips, inEach, [this](std::size_t strip) { sortStrip(strip); });
}

void BinLattice::countStrips(std::span<const Body> bodies)
{
    m_inStrip.assign((bodies.size() / kRowsAtOnce + 1) * kStrips, 0);
    overRows(bodies.size(), [&](std::size_t begin, std::size_t end) {
        std::uint32_t* const inStrip = &m_inStrip[begin / kRowsAtOnce * kStrips];
        for (std::size_t agent = begin; agent < end; ++agent) {
            const auto column =
                static_cast<std::uint32_t>((bodies[agent].x - m_lowX) * m_perMetreX);
            const auto line = static_cast<std::uint32_t>((bodies[agent].z - m_lowZ) * m_perMetreZ);
            const std::uint32_t bin = line * m_width + column;
            m_binOfAgent[agent] = bin;
            ++inStrip[bin >> m_stripShift];
        }
    });
}

void BinLattice::sortIntoStrips()
{
    std::uint32_t total = 0;
    for (std::size_t strip = 0; strip < kStrips; ++strip) {
        m_stripStart[strip] = total;
        for (std::size_t i = strip; i < m_inStrip.size(); i += kStrips) {
            total += std::exchange(m_inStrip[i], total);
        }
    }
    m_stripStart[kStrips] = total;
    overRows(m_binOfAgent.size(), [&](std::size_t begin, std::size_t end) {
        std::uint32_t* const next = &m_inStrip[begin / kRowsAtOnce * kStrips];
        for (std::size_t agent = begin; agent < end; ++agent) {
            const std::uint32_t bin = m_binOfAgent[agent];
            m_byStrip[next[bin >> m_stripShift]++] = {bin, static_cast<std::uint32_t>(agent)};
        }
    });
}

void BinLattice::sortStrip(std::size_t strip)
{
    const std::span<const Binned> people{m_byStrip.data() + m_stripStart[strip],
                                         m_byStrip.data() + m_stripStart[strip + 1]};
    const std::size_t first = strip << m_stripShift;
    const std::size_t end = std::min((strip + 1) << m_stripShift, m_start.size() - 1);
    std::fill(&m_start[first], &m_start[end], 0);
    for (const Binned& each : people) {
        ++m_start[each.bin];
    }
    std::uint32_t total = m_stripStart[strip];
    for (std::size_t bin = first; bin < end; ++bin) {
        total += m_start[bin];
        m_start[bin] = total;
    }
    // Each entry is the end of its bin now, and its first row when the bin is full.
    for (std::size_t i = people.size(); i-- > 0;) {
        const std::uint32_t row = --m_start[people[i].bin];
        m_agents[row] = people[i].agent;
        m_binOfRow[row] = people[i].bin;
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
    return sizeof(std::uint32_t) * (m_start.size() + m_binOfAgent.size() + m_binOfRow.size() +
                                    m_agents.size() + 2 * m_byStrip.size() + m_inStrip.size());
}

} // namespace crowd::behavior
