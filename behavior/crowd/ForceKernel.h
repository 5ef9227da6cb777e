// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "behavior/crowd/AgentColumns.h"
#include "behavior/crowd/BinLattice.h"
#include "behavior/crowd/ForceParameters.h"
#include "behavior/crowd/WallField.h"

namespace crowd::behavior {

/// One step of some rows: reads everybody as they were, writes only these rows of the outputs.
struct ForceJob
{
    const AgentColumns& agents; ///< sorted by `lattice`
    const BinLattice& lattice;  ///< of bins at least ForceParameters::range wide
    const WallField& walls;
    const ForceParameters& parameters;
    const float* facingX = nullptr; ///< of everybody, from faceRows()
    const float* facingZ = nullptr;
    float seconds = 0.0F;   ///< length of the step
    bool hasLevels = false; ///< whether people may stand above each other
    float* x = nullptr;     ///< outputs, by row
    float* z = nullptr;
    float* velocityX = nullptr;
    float* velocityZ = nullptr;
    std::uint8_t* isCrowded = nullptr; ///< 1: somebody may come too close within this step
};

/// People whose feet are further apart than this are on different levels, metres.
inline constexpr float kLevelMetres = 1.2F;

/// Unit vectors of where some rows want to go; zero: nowhere.
void faceRows(const AgentColumns& agents, std::size_t begin, std::size_t end, float* facingX,
              float* facingZ);

/// Social force, semi-implicit Euler, walls. The same bits for any division into rows, on any
/// machine of a type.
void advanceRows(const ForceJob& job, std::size_t begin, std::size_t end);

/// Moves rows that are too close to somebody half the way apart (all of it from those who do not
/// move), reading x and z of `agents` and writing those of the job. Returns how many had to move.
std::size_t separateRows(const ForceJob& job, std::size_t begin, std::size_t end);

} // namespace crowd::behavior
