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

/// One step of some rows: reads everybody as they were, writes only these rows: their velocities
/// in place, for others see those in AgentRows::seen, and the outputs.
struct ForceJob
{
    AgentRows& agents;
    const BinLattice& lattice; ///< of bins at least ForceParameters::range wide
    const WallField& walls;
    const ForceParameters& parameters;
    float seconds = 0.0F;   ///< length of the step
    bool hasLevels = false; ///< whether people may stand above each other
    float* x = nullptr;     ///< outputs, by row
    float* z = nullptr;
    std::uint8_t* isCrowded = nullptr; ///< 1: somebody may come too close within this step
};

/// People whose feet are further apart than this are on different levels, metres.
inline constexpr float kLevelMetres = 1.2F;

/// Takes bodies into some rows, all but their heights.
void gatherRows(const Body* bodyOfAgent, const std::uint32_t* agentOfRow, AgentRows& rows,
                std::size_t begin, std::size_t end, bool hasPlainInstructions);

/// Social force, semi-implicit Euler, walls. The same bits for any division into rows, on any
/// machine of a type.
void advanceRows(const ForceJob& job, std::size_t begin, std::size_t end);

/// Moves rows that are too close to somebody half the way apart (all of it from those who do not
/// move), reading x and z of `agents` and writing those of the job. Returns how many had to move.
std::size_t separateRows(const ForceJob& job, std::size_t begin, std::size_t end);

} // namespace crowd::behavior
