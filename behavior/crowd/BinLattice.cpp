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

Box boxOf(const AgentColumns& columns)
{
    Box box{columns.x[0], columns.x[0], columns.z[0], columns.z[0]};
    for (std::size_t row = 1; row < columns.size(); ++row) {
        box.lowX = std::min(box.lowX, columns.x[row]);
        box.highX = std::max(box.highX, columns.x[row]);
        box.lowZ = std::min(box.lowZ, columns.z[row]);
        box.highZ = std::max(box.highZ, columns.z[row]);
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

void BinLattice::place(const AgentColumns& columns, float binSize)
{
    const Box box = boxOf(columns);
    const auto most = static_cast<double>(kBinsPerAgent * columns.size() + kFewBins);
    while (binsAlong(box.lowX, box.highX, binSize) * binsAlong(box.lowZ, box.highZ, binSize) >
           most) {
        binSize *= 2.0F;
    }
    m_lowX = box.lowX;
    m_lowZ = box.lowZ;
    m_perMetre = 1.0F / binSize;
    m_width = static_cast<std::uint32_t>((box.highX - box.lowX) * m_perMetre) + 1;
    m_depth = static_cast<std::uint32_t>((box.highZ - box.lowZ) * m_perMetre) + 1;
}

/// Counting sort by bin, then by agent within a bin.
void BinLattice::fill(const AgentColumns& columns)
{
    const std::size_t rows = columns.size();
    m_unsorted.resize(rows);
    m_binOfRow.resize(rows);
    m_order.resize(rows);
    m_start.assign(std::size_t{m_width} * m_depth + 1, 0);
    for (std::size_t row = 0; row < rows; ++row) {
        const auto column = static_cast<std::uint32_t>((columns.x[row] - m_lowX) * m_perMetre);
        const auto line = static_cast<std::uint32_t>((columns.z[row] - m_lowZ) * m_perMetre);
        m_unsorted[row] = line * m_width + column;
        ++m_start[m_unsorted[row]];
    }
    std::uint32_t total = 0;
    for (std::uint32_t& start : m_start) {
        total += start;
        start = total;
    }
    // Each entry is the end of its bin now, and its first row when the bin is full.
    for (std::size_t row = rows; row-- > 0;) {
        m_order[--m_start[m_unsorted[row]]] = static_cast<std::uint32_t>(row);
    }
    for (std::size_t row = 0; row < rows; ++row) {
        m_binOfRow[row] = m_unsorted[m_order[row]];
    }
    for (std::size_t row = 1; row < rows; ++row) {
        // Insertion: rows keep nearly the same order from step to step.
        const std::uint32_t bin = m_binOfRow[row];
        const std::uint32_t item = m_order[row];
        std::size_t hole = row;
        while (hole > 0 && m_binOfRow[hole - 1] == bin &&
               columns.agent[m_order[hole - 1]] > columns.agent[item]) {
            m_order[hole] = m_order[hole - 1];
            --hole;
        }
        m_order[hole] = item;
    }
}

void BinLattice::sort(AgentColumns& columns, AgentColumns& spare, float binSize)
{
    if (columns.size() == 0) {
        return;
    }
    place(columns, binSize);
    fill(columns);
    spare.resize(columns.size());
    overRows(columns.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            spare.agent[row] = columns.agent[m_order[row]];
        }
        for (std::vector<float> AgentColumns::*column : AgentColumns::kFloats) {
            const float* from = (columns.*column).data();
            float* to = (spare.*column).data();
            for (std::size_t row = begin; row < end; ++row) {
                to[row] = from[m_order[row]];
            }
        }
    });
    std::swap(columns, spare);
}

std::size_t BinLattice::bytes() const
{
    return sizeof(std::uint32_t) *
           (m_start.size() + m_unsorted.size() + m_binOfRow.size() + m_order.size());
}

} // namespace crowd::behavior
