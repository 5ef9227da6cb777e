// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace crowd::behavior {

/// Number of floats that the kernel takes at once on every machine, so that sums are the same
/// everywhere. Columns have as many spare elements at their end.
inline constexpr std::size_t kLanes = 8;

/// What others notice of somebody. Metres, metres per second.
struct alignas(32) Seen
{
    float x = 0.0F;
    float z = 0.0F;
    float velocityX = 0.0F;
    float velocityZ = 0.0F;
    float radius = 0.0F;
    float facingX = 0.0F; ///< unit vector of where he wants to go; zero: nowhere
    float facingZ = 0.0F;
    float preferredSpeed = 0.0F; ///< see Body
};

/// Everybody during a step, in the order of the bins; units as in Body. Columns where many are
/// looked at in a row, records where one picks a few.
struct AgentRows
{
    std::vector<float> x;
    std::vector<float> z;
    std::vector<float> y; ///< height of the ground underfoot
    std::vector<float> desiredSpeed;
    std::vector<Seen> seen;
    /// Agent that a row belongs to; below 0, -1 - agent, for the discs of a long body. Only kept
    /// where there are such bodies: see LongBody.
    std::vector<std::int32_t> owner;

    [[nodiscard]] bool isLong(std::size_t row) const { return !owner.empty() && owner[row] < 0; }
    [[nodiscard]] std::size_t size() const { return m_size; }
    void resize(std::size_t rows, bool hasLongBodies)
    {
        m_size = rows;
        owner.resize(hasLongBodies ? rows + kLanes : 0);
        for (std::vector<float> AgentRows::*column : kFloats) {
            (this->*column).resize(rows + kLanes);
        }
        seen.resize(rows + kLanes);
    }
    [[nodiscard]] std::size_t bytes() const
    {
        return std::size(kFloats) * x.size() * sizeof(float) + seen.size() * sizeof(Seen) +
               owner.size() * sizeof(std::int32_t);
    }

    static constexpr std::vector<float> AgentRows::*kFloats[] = {
        &AgentRows::x, &AgentRows::z, &AgentRows::y, &AgentRows::desiredSpeed};

private:
    std::size_t m_size = 0;
};

} // namespace crowd::behavior
