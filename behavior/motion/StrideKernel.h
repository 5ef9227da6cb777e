// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "behavior/crowd/Body.h"
#include "behavior/motion/MotionState.h"
#include "model/scene/Path.h"

/// Steering and motion of agents in UpdateMode::Continue, many at once in vector registers. `begin`
/// is a multiple of kLanes, and at most kStrideBlock agents are given at a time. Each function
/// leaves the agents that need a full update as they are, lists them in ascending order in
/// `needUpdate` (kStrideBlock + kLanes elements), and returns how many those are. The same bits for
/// any division into calls and on any processor. Any thread; calls for disjoint agents may run at
/// the same time.
namespace crowd::behavior {

/// A multiple of kLanes, so that what is kept of them fits the stack.
inline constexpr std::size_t kStrideBlock = 512;

/// Where people walk slower.
struct SlowArea
{
    glm::vec2 center{0.0F};
    float radius = 0.0F;
    float share = 1.0F;                               ///< of the usual speed
    std::optional<model::Place> shape = std::nullopt; ///< where it is not round, within `radius`
};

/// Whether somebody who is within its radius is in it.
[[nodiscard]] bool isInShape(const SlowArea& area, float x, float z);

/// Where agents go while they go straight on, by agent; with spare elements as in MotionState.
struct Aims
{
    std::vector<float> x;
    std::vector<float> z;
    std::vector<float> pace;        ///< m/s; 0: stands
    std::vector<std::int32_t> mode; ///< UpdateMode
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
                            std::uint32_t* needUpdate, bool hasPlainInstructions = false);

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

/// Takes the new positions and speeds over into the motion state after bodies have moved.
std::size_t strideOn(std::span<const Body> bodies, std::span<const float> heights,
                     MotionState& motion, const StrideParameters& parameters, std::size_t begin,
                     std::size_t end, std::uint32_t* needUpdate);

} // namespace crowd::behavior
