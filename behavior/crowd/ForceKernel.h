// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "behavior/crowd/AgentRows.h"
#include "behavior/crowd/BinLattice.h"
#include "behavior/crowd/Body.h"
#include "behavior/crowd/ForceParameters.h"
#include "behavior/crowd/WallField.h"

namespace crowd::behavior {

/// One step of some rows: reads everybody as they were, writes only these rows' outputs.
struct ForceJob
{
    const AgentRows& agents;
    const BinLattice& lattice; ///< reaches at least as far as `reach`
    const WallField& walls;
    const ForceParameters& parameters;
    float seconds = 0.0F;   ///< length of the step
    float reach = 0.0F;     ///< metres: people further away are not noticed
    bool hasLevels = false; ///< whether people may stand above each other
    float* x = nullptr;     ///< outputs, by row
    float* z = nullptr;
    float* velocityX = nullptr;
    float* velocityZ = nullptr;
    /// Output and input, by row, metres: how much others may differ from the way that they were on
    /// before somebody comes too close. Those who stand have no end of it: they are not moved.
    float* slack = nullptr;
};

/// People whose feet are further apart than this are on different levels, metres.
inline constexpr float kLevelMetres = 1.2F;

/// Takes bodies into some rows, all but their heights.
void gatherRows(const Body* bodyOfAgent, const std::uint32_t* agentOfRow, AgentRows& rows,
                std::size_t begin, std::size_t end, bool hasPlainInstructions);

/// Social force, semi-implicit Euler, walls. The same bits for any division into rows, on any
/// machine of a type. Returns how far somebody got away from the way that he was on, at most.
[[nodiscard]] float advanceRows(const ForceJob& job, std::size_t begin, std::size_t end);

struct Separated
{
    std::size_t count = 0; ///< of those who moved
    float furthest = 0.0F; ///< metres
};

/// Moves rows that are too close to somebody half the way apart (all of it from those who do not
/// move): writes the job's x and z of those and lists them, ascending. Nobody who has at least
/// `reach` of slack is looked at.
[[nodiscard]] Separated separateRows(const ForceJob& job, std::size_t begin, std::size_t end,
                                     float reach, std::uint32_t* moved);

} // namespace crowd::behavior
