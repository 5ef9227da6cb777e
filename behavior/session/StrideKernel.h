// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "behavior/crowd/Body.h"
#include "behavior/session/Bearings.h"

/// What everybody does in a step as long as nothing happens to him, many people at once. Agents
/// are given from a multiple of kLanes on. Each function returns how many of them need a look by
/// themselves, whom it has left alone, and lists those, ascending. At most kStrideBlock agents at a
/// time; the same bits for any division, and whatever the processor can do.
namespace crowd::behavior {

/// A multiple of kLanes, so that what is kept of them fits the stack.
inline constexpr std::size_t kStrideBlock = 512;

/// Where people walk slower.
struct SlowArea
{
    glm::vec2 center{0.0F};
    float radius = 0.0F;
    float share = 1.0F; ///< of the usual speed
};

/// Where people go while they go straight on, by agent; with spare elements as in Bearings.
struct Aims
{
    std::vector<float> x;
    std::vector<float> z;
    std::vector<float> pace;          ///< m/s; 0: stands
    std::vector<std::int32_t> course; ///< Course
};

/// Who goes nearer than this has arrived, metres.
inline constexpr float kArrivalMetres = 0.4F;
/// How people come to rest where nothing hurries them, m/s². Whoever is so fast that he would rest
/// beyond his point has arrived so much earlier.
inline constexpr float kUsualBraking = 3.0F;
/// Who was pushed off his point has arrived when he is past it and not further away than this.
inline constexpr float kPassedMetres = 1.5F;

/// Lets people wish to go where they aim at.
std::size_t steerStraightOn(std::span<Body> bodies, const Aims& aims,
                            std::span<const SlowArea> slow, std::size_t begin, std::size_t end,
                            std::uint32_t* look, bool hasPlainInstructions = false);

/// Constants of a session.
struct StrideParameters
{
    float stepSeconds = 1.0F / 30.0F;
    float smoothing = 0.0F;            ///< of speeds, a step
    float mostTurn = 0.0F;             ///< radians a step
    float turnsAbove = 0.0F;           ///< m/s: below, nobody turns to where he is pushed
    float movesAbove = 0.0F;           ///< m/s: below, nobody is taken for moving
    float fastest = 0.0F;              ///< m/s: faster is no walk but a jump
    bool hasPlainInstructions = false; ///< as ForceParameters::plainInstructions
};

/// Bearings after bodies have moved.
std::size_t strideOn(std::span<const Body> bodies, std::span<const float> heights,
                     Bearings& bearings, const StrideParameters& parameters, std::size_t begin,
                     std::size_t end, std::uint32_t* look);

} // namespace crowd::behavior
