// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace crowd::behavior {

/// Number of floats that the kernel takes at once on every machine, so that sums are the same
/// everywhere. Columns have as many spare elements at their end.
inline constexpr std::size_t kLanes = 8;

/// Everybody in the simulation, structure of arrays. World frame seen from above: x and z in
/// metres, y the height of the ground underfoot; metres per second. Rows lie in the order of the
/// bins and move at every step: `agent` names who stands in a row.
struct AgentColumns
{
    std::vector<std::uint32_t> agent;
    std::vector<float> x;
    std::vector<float> z;
    std::vector<float> y;
    std::vector<float> velocityX;
    std::vector<float> velocityZ;
    std::vector<float> desiredX; ///< velocity that the agent would like
    std::vector<float> desiredZ;
    /// 0: stands or sits, an obstacle that does not move; below 0: is coming to rest, straight on
    /// and slowing down by so many m/s².
    std::vector<float> preferredSpeed;
    std::vector<float> radius;

    [[nodiscard]] std::size_t size() const { return m_size; }
    void resize(std::size_t rows)
    {
        m_size = rows;
        agent.resize(rows);
        for (std::vector<float> AgentColumns::*column : kFloats) {
            (this->*column).resize(rows + kLanes);
        }
    }

    static constexpr std::vector<float> AgentColumns::*kFloats[] = {
        &AgentColumns::x,         &AgentColumns::z,
        &AgentColumns::y,         &AgentColumns::velocityX,
        &AgentColumns::velocityZ, &AgentColumns::desiredX,
        &AgentColumns::desiredZ,  &AgentColumns::preferredSpeed,
        &AgentColumns::radius};

private:
    std::size_t m_size = 0;
};

} // namespace crowd::behavior
