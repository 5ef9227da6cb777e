// SPDX-License-Identifier: MIT
#include "behavior/crowd/ForceKernel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "behavior/crowd/Avx2.h"
#include "behavior/crowd/FastExp.h"
#include "behavior/crowd/PackOrders.h"
#include "behavior/crowd/WallForce.h"

namespace crowd::behavior {

namespace {

/// More than fit around anybody who has not been walked into; the rest is not noticed.
constexpr std::size_t kMostNeighbours = 256;
/// Nobody is moved further at once, metres: where many stand on one spot each would push him on.
constexpr float kFarthestApart = 0.06F;
/// So many too close are enough to know which way is out: on one spot there can be thousands.
constexpr std::size_t kMostClose = 24;
/// Of two bodies of the size that the force is made for, metres.
constexpr float kPersonRadii = 0.5F;
constexpr float kAnyReach = 1e30F;  ///< slack of whom nobody comes too close
constexpr std::size_t kBatch = 256; ///< rows whose sums lie in the fastest cache

constexpr std::size_t kGathered = 2 * kMostNeighbours; ///< so that all fit the fastest cache

/// A column of it. The spare lanes are for what is written beyond the end; with them columns do not
/// lie a power of two apart, which the cache would not like.
using NeighbourColumn = float[kGathered + kLanes];

/// Those within range of each of some successive rows.
struct Neighbours
{
    std::size_t start[kBatch + 1]; ///< of each row of the batch
    std::uint32_t row[kGathered + kLanes];
    // As seen from the row; soon: when both have gone on for a while.
    NeighbourColumn x; ///< then its force on the row
    NeighbourColumn z;
    NeighbourColumn soonX;
    NeighbourColumn soonZ;
    NeighbourColumn squaredStep;
    NeighbourColumn parting;   ///< relative velocity along the way between both, times its length
    NeighbourColumn radius;    ///< sum of both; then the room before both must be separated
    NeighbourColumn ahead;     ///< metres against the way that the row faces
    NeighbourColumn soonAhead; ///< then the repulsion against that way
    NeighbourColumn counted;   ///< less: comes towards it; then how much it adds to the density
    NeighbourColumn distance;
    NeighbourColumn soon;
    NeighbourColumn axis; ///< twice the short half-axis of the ellipse
};

/// What neighbours and walls do to each of a batch of rows.
struct Sums
{
    float x[kBatch] = {};
    float z[kBatch] = {};
    float backward[kBatch] = {}; ///< repulsion against the way one faces
    float density[kBatch] = {};
    float closest[kBatch] = {}; ///< room to the nearest before both must be separated
    float wallX[kBatch] = {};
    float wallZ[kBatch] = {};
    float hidden[kBatch] = {};
};

/// What the kernel has to look at beside places on a plane. Each also does what those before it do.
enum class Crowd : std::uint8_t {
    Flat,
    Levels, ///< people above each other
    Long    ///< bodies made of several rows, which do not press on each other
};

Crowd kindOf(const ForceJob& job)
{
    return !job.agents.owner.empty() ? Crowd::Long : job.hasLevels ? Crowd::Levels : Crowd::Flat;
}

float flatLength(float x, float z)
{
    return std::sqrt(x * x + z * z);
}

/// Which part of the way out of somebody too close one goes: half of it, all of it when the other
/// does not move. A long body is not turned out of its way by somebody who can make room.
float shareOfWay(const AgentRows& agents, std::size_t row, std::size_t other)
{
    const bool canMakeRoom = agents.seen[other].preferredSpeed != 0.0F;
    if (canMakeRoom && agents.isLong(row) != agents.isLong(other)) {
        return agents.isLong(row) ? 0.0F : 1.0F;
    }
    return canMakeRoom ? 0.5F : 1.0F;
}

void leave(const AgentRows& agents, std::size_t row, std::size_t other, float least, float& wayX,
           float& wayZ)
{
    const float x = agents.x[row] - agents.x[other];
    const float z = agents.z[row] - agents.z[other];
    const float share = shareOfWay(agents, row, other);
    const float distance = std::sqrt(x * x + z * z);
    if (distance > 1e-4F) {
        wayX += share * x * (least - distance) / distance;
        wayZ += share * z * (least - distance) / distance;
    } else {
        // On the same spot: apart along a line that both agree on, others along other lines.
        constexpr std::array<std::array<float, 2>, 4> kLines = {
            {{1.0F, 0.0F}, {0.0F, 1.0F}, {0.7071F, 0.7071F}, {0.7071F, -0.7071F}}};
        const std::size_t mixed = (row ^ other) * std::size_t{0x9E3779B97F4A7C15U} + row + other;
        const auto& line = kLines[mixed >> 61U & 3U];
        const float way = row < other ? share * least : -share * least;
        wayX += way * line[0];
        wayZ += way * line[1];
    }
}

#define CROWD_KERNEL_BODY "behavior/crowd/ForceKernelBody.h"
#include "behavior/crowd/KernelCopies.h"

using Advance = float (*)(const ForceJob&, std::size_t, std::size_t);
using Separate = Separated (*)(const ForceJob&, std::size_t, std::size_t, float, std::uint32_t*);

} // namespace

void gatherRows(const Body* bodyOfAgent, const std::uint32_t* agentOfRow, AgentRows& rows,
                std::size_t begin, std::size_t end, [[maybe_unused]] bool hasPlainInstructions)
{
#ifdef CROWD_HAS_AVX2
    if (hasAvx2() && !hasPlainInstructions) {
        with_avx2::gather(bodyOfAgent, agentOfRow, rows, begin, end);
        return;
    }
#endif
    any_processor::gather(bodyOfAgent, agentOfRow, rows, begin, end);
}

float advanceRows(const ForceJob& job, std::size_t begin, std::size_t end)
{
    const std::size_t crowd = static_cast<std::size_t>(kindOf(job));
    const std::size_t slows = job.parameters.slowing > 0.0F ? 1 : 0;
#ifdef CROWD_HAS_AVX2
    if (hasAvx2() && !job.parameters.plainInstructions) {
        constexpr Advance kKinds[][2] = {
            {with_avx2::advance<Crowd::Flat, false>, with_avx2::advance<Crowd::Flat, true>},
            {with_avx2::advance<Crowd::Levels, false>, with_avx2::advance<Crowd::Levels, true>},
            {with_avx2::advance<Crowd::Long, false>, with_avx2::advance<Crowd::Long, true>}};
        return kKinds[crowd][slows](job, begin, end);
    }
#endif
    constexpr Advance kKinds[][2] = {
        {any_processor::advance<Crowd::Flat, false>, any_processor::advance<Crowd::Flat, true>},
        {any_processor::advance<Crowd::Levels, false>, any_processor::advance<Crowd::Levels, true>},
        {any_processor::advance<Crowd::Long, false>, any_processor::advance<Crowd::Long, true>}};
    return kKinds[crowd][slows](job, begin, end);
}

Separated separateRows(const ForceJob& job, std::size_t begin, std::size_t end, float reach,
                       std::uint32_t* moved)
{
    const std::size_t crowd = static_cast<std::size_t>(kindOf(job));
#ifdef CROWD_HAS_AVX2
    if (hasAvx2() && !job.parameters.plainInstructions) {
        constexpr Separate kKinds[] = {with_avx2::separate<Crowd::Flat>,
                                       with_avx2::separate<Crowd::Levels>,
                                       with_avx2::separate<Crowd::Long>};
        return kKinds[crowd](job, begin, end, reach, moved);
    }
#endif
    constexpr Separate kKinds[] = {any_processor::separate<Crowd::Flat>,
                                   any_processor::separate<Crowd::Levels>,
                                   any_processor::separate<Crowd::Long>};
    return kKinds[crowd](job, begin, end, reach, moved);
}

} // namespace crowd::behavior
