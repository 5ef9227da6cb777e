// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "behavior/crowd/Body.h"

namespace crowd::behavior {

/// Bins over all agents, filled by a counting sort into rows. The rows of a bin lie next to
/// each other, ascending by agent: the order depends on where people stand, not on how they came
/// there. Bins of one line of the lattice lie next to each other too, so the neighbourhood of a bin
/// is three spans; bins are narrow along the line, so that not many are in them who are too far
/// away.
class BinLattice
{
public:
    struct Span
    {
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
    };

    /// Neighbourhoods reach at least `range` far (further where people are spread thin, so that
    /// there are never many more bins than people).
    void sort(std::span<const Body> bodies, float range);

    /// Agent of each row.
    [[nodiscard]] std::span<const std::uint32_t> agents() const { return m_agents; }
    [[nodiscard]] std::uint32_t binOfRow(std::size_t row) const { return m_binOfRow[row]; }
    /// A line of bins; remembered from bin to bin it saves a division for most.
    struct Line
    {
        std::uint32_t number = 0;
        std::uint32_t first = 0; ///< bin
    };
    /// Rows of the bins around a bin: lattice lines below, same, above; empty ones outside.
    /// `line` is any, and then that of the bin.
    void neighbourhood(std::uint32_t bin, Line& line, Span (&spans)[3]) const;
    [[nodiscard]] std::size_t bytes() const;

private:
    static constexpr std::uint32_t kAcross = 2; ///< bins along a line in the range

    void place(std::span<const Body> bodies, float range);
    void fill(std::span<const Body> bodies);
    void countStrips(std::span<const Body> bodies);
    void sortIntoStrips();
    void sortStrip(std::size_t strip);

    struct Binned
    {
        std::uint32_t bin = 0;
        std::uint32_t agent = 0;
    };

    /// A strip is a range of successive bins, a power of two of them.
    static constexpr int kStripBits = 6;
    static constexpr std::size_t kStrips = std::size_t{1} << kStripBits;

    float m_lowX = 0.0F;
    float m_lowZ = 0.0F;
    float m_perMetreX = 1.0F; ///< bins
    float m_perMetreZ = 1.0F;
    std::uint32_t m_width = 1;
    std::uint32_t m_depth = 1;
    std::vector<std::uint32_t> m_start;      ///< first row of each bin, and the end of the last
    std::vector<std::uint32_t> m_binOfAgent; ///< before the sort
    std::vector<std::uint32_t> m_binOfRow;   ///< and after it
    std::vector<std::uint32_t> m_agents;
    // While sorting:
    std::uint32_t m_stripShift = 0; ///< a bin's strip is its number without so many bits
    std::uint32_t m_stripStart[kStrips + 1] = {}; ///< first row of each, and the end of the last
    std::vector<Binned> m_byStrip;                ///< people of each strip, ascending by agent
    /// Of each chunk of agents: how many are in each strip, then where the next of them goes.
    std::vector<std::uint32_t> m_inStrip;
};

[[gnu::always_inline]] inline void BinLattice::neighbourhood(std::uint32_t bin, Line& line,
                                                             Span (&spans)[3]) const
{
    if (bin - line.first >= m_width) {
        line.number = bin / m_width;
        line.first = line.number * m_width;
    }
    const std::uint32_t column = bin - line.first;
    const std::uint32_t left = std::max(column, kAcross) - kAcross;
    const std::uint32_t right = std::min(column + kAcross, m_width - 1);
    for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t other = line.number + i; // one too high, so that it cannot be negative
        spans[i] = {};
        if (other >= 1 && other <= m_depth) {
            const std::size_t first = std::size_t{other - 1} * m_width;
            spans[i] = {m_start[first + left], m_start[first + right + 1]};
        }
    }
}

} // namespace crowd::behavior
