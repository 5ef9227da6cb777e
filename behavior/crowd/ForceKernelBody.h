// SPDX-License-Identifier: MIT
// The force kernel, included by ForceKernel.cpp once for each instruction set, in a namespace of
// its own and after all headers that it needs: hence no include guard. With CROWD_KERNEL_AVX2 the
// few steps that plain C++ cannot say are intrinsics; both copies give the same bits.

#include "behavior/crowd/KernelLanes.h"

/// Bits of the lanes of a block that belong to a span and are not `row` itself.
CROWD_INLINE unsigned bitsOfOthers(std::size_t first, std::size_t end, std::size_t row)
{
    const unsigned bits = (1U << std::min(kLanes, end - first)) - 1U;
    const std::size_t own = row - first;
    return own < kLanes ? bits & ~(1U << own) : bits;
}

CROWD_INLINE F8 squaredDistances(const F8& x, const F8& z)
{
    return x * x + z * z;
}

/// Everybody within range of a row, relative to it, in order of rows, from `at` on; returns where
/// the next row's begin.
template<bool kHasLevels, bool kSlows>
CROWD_INLINE std::size_t collect(const ForceJob& job, std::size_t row,
                                 const BinLattice::Span (&spans)[3], Neighbours& near,
                                 std::size_t at)
{
    const std::size_t most = at + kMostNeighbours - kLanes;
    const AgentColumns& agents = job.agents;
    const F8 selfX = all(agents.x[row]);
    const F8 selfZ = all(agents.z[row]);
    const F8 selfVelocityX = all(agents.velocityX[row]);
    const F8 selfVelocityZ = all(agents.velocityZ[row]);
    const F8 selfRadius = all(agents.radius[row]);
    const F8 squaredRange = all(job.parameters.range * job.parameters.range);
    std::size_t count = at;
    for (const BinLattice::Span& span : spans) {
        for (std::size_t first = span.begin; first < span.end; first += kLanes) {
            const F8 x = selfX - load(agents.x.data() + first);
            const F8 z = selfZ - load(agents.z.data() + first);
            F8 squared = squaredDistances(x, z);
            if constexpr (kHasLevels) {
                const F8 above = load(agents.y.data() + first) - agents.y[row];
                squared += greater(above, -above) > kLevelMetres ? all(1e12F) : all(0.0F);
            }
            const unsigned bits =
                bitsWhereLess(squared, squaredRange) & bitsOfOthers(first, span.end, row);
            const F8 velocityX = selfVelocityX - load(agents.velocityX.data() + first);
            const F8 velocityZ = selfVelocityZ - load(agents.velocityZ.data() + first);
            const F8 radius = selfRadius + load(agents.radius.data() + first);
            if constexpr (kSlows) {
                count = pack({x, z, velocityX, velocityZ, radius, load(job.facingX + first),
                              load(job.facingZ + first)},
                             bits,
                             {near.x, near.z, near.velocityX, near.velocityZ, near.radius,
                              near.facingX, near.facingZ},
                             count);
            } else {
                count = pack({x, z, velocityX, velocityZ, radius}, bits,
                             {near.x, near.z, near.velocityX, near.velocityZ, near.radius}, count);
            }
            count = std::min(count, most);
        }
    }
    // The last block is filled up with somebody too far away to matter.
    store(near.x + count, all(1e3F));
    store(near.z + count, all(1e3F));
    store(near.velocityX + count, all(0.0F));
    store(near.velocityZ + count, all(0.0F));
    store(near.radius + count, all(0.0F));
    if constexpr (kSlows) {
        store(near.facingX + count, all(0.0F));
        store(near.facingZ + count, all(0.0F));
    }
    return at + (count - at + kLanes - 1) / kLanes * kLanes;
}

/// Repulsion and contact of all neighbours of a row.
template<bool kSlows>
CROWD_INLINE void addNeighbours(const ForceJob& job, std::size_t row, const Neighbours& near,
                                Sums& sums, std::size_t at)
{
    const ForceParameters& p = job.parameters;
    const float perReach = -0.5F / p.reach;
    const float perSquare = 1.0F / (p.range * p.range);
    const float blind = 0.5F * (1.0F - p.fromBehind);
    const float facingX = job.facingX[row];
    const float facingZ = job.facingZ[row];
    F8 sumX{};
    F8 sumZ{};
    F8 backward{};
    F8 density{};
    F8 closest = all(1e3F);
    const std::size_t end = near.start[at + 1];
    for (std::size_t first = near.start[at]; first < end; first += kLanes) {
        const F8 x = load(near.x + first);
        const F8 z = load(near.z + first);
        const F8 stepX = load(near.velocityX + first) * p.anticipationSeconds;
        const F8 stepZ = load(near.velocityZ + first) * p.anticipationSeconds;
        const F8 squared = greater(squaredDistances(x, z), all(kSmallest));
        const F8 distance = squareRoot(squared);
        const F8 soonX = x + stepX;
        const F8 soonZ = z + stepZ;
        const F8 soon = squareRoot(greater(squaredDistances(soonX, soonZ), all(kSmallest)));
        const F8 sum = distance + soon;
        // Twice the short half-axis of the ellipse.
        const F8 axis = squareRoot(
            greater(sum * sum - squaredDistances(stepX, stepZ), all(p.leastAxis * p.leastAxis)));
        // One division for all three: they are what takes longest.
        const F8 perAll = 1.0F / (distance * soon * axis);
        const F8 perDistance = perAll * (soon * axis);
        const F8 perSoon = perAll * (distance * axis);
        const F8 perAxis = perAll * (distance * soon);
        const F8 unitX = x * perDistance;
        const F8 unitZ = z * perDistance;
        const F8 ahead = -(unitX * facingX + unitZ * facingZ);
        const F8 seen = p.fromBehind + blind * (1.0F + ahead);
        const F8 nearness = greater(1.0F - squared * perSquare, all(0.0F));
        const F8 push =
            nearness * seen * exponential(axis * perReach) * (sum * perAxis) * (0.5F * p.strength);
        const F8 radius = load(near.radius + first);
        const F8 touch = p.contact * greater(radius - distance, all(0.0F));
        sumX += push * (unitX + soonX * perSoon) + touch * unitX;
        sumZ += push * (unitZ + soonZ * perSoon) + touch * unitZ;
        F8 presence = nearness * nearness * (1.0F + ahead);
        if constexpr (kSlows) {
            const F8 against =
                -(load(near.facingX + first) * facingX + load(near.facingZ + first) * facingZ);
            const F8 counted = 1.0F - p.oncoming * greater(against, all(0.0F));
            const F8 forward = push * ((soonX * facingX + soonZ * facingZ) * perSoon - ahead);
            backward += lesser(forward, all(0.0F)) * counted;
            presence *= counted;
        }
        density += presence;
        closest = lesser(closest, distance - p.closest * radius);
    }
    const F4 total = sumsOf(sumX, sumZ, backward, density);
    sums.x[at] = total[0];
    sums.z[at] = total[1];
    sums.backward[at] = total[2];
    sums.density[at] = total[3];
    sums.closest[at] = leastOf(closest);
}

/// Walking speed among so many per square metre, as a share of the free one (Weidmann 1993).
CROWD_INLINE F8 weidmann(F8 perSquareMetre)
{
    constexpr float kJam = 5.4F;
    const F8 room = 1.0F / greater(perSquareMetre, all(0.01F)) - 1.0F / kJam;
    return 1.0F - exponential(-1.913F * greater(room, all(0.01F)));
}

/// Writes as many lanes as there are: what follows belongs to others.
CROWD_INLINE void storeSome(float* to, F8 value, std::size_t lanes)
{
    if (lanes >= kLanes) {
        store(to, value);
        return;
    }
    for (std::size_t l = 0; l < lanes; ++l) {
        to[l] = value[l];
    }
}

/// Velocity and place of a block of rows after the step, walls apart.
template<bool kSlows>
CROWD_INLINE void moveBlock(const ForceJob& job, std::size_t row, std::size_t lanes,
                            const Sums& sums, std::size_t at)
{
    const ForceParameters& p = job.parameters;
    const AgentColumns& agents = job.agents;
    // The mean over a disk of the nearness is a third of it.
    const float perDisk = 1.0F / (3.14159265F / 3.0F * p.range * p.range);
    const F8 facingX = load(job.facingX + row);
    const F8 facingZ = load(job.facingZ + row);
    const F8 wallX = load(sums.wallX + at);
    const F8 wallZ = load(sums.wallZ + at);
    const F8 visible = greater(1.0F - load(sums.hidden + at), all(0.3F));
    const F8 around = load(sums.density + at) * perDisk / visible;
    // Nobody presses on where there is no room at all.
    F8 pace = lesser(greater((p.jam - around) * 0.5F, all(0.0F)), all(1.0F));
    F8 forceX = load(sums.x + at) + wallX;
    F8 forceZ = load(sums.z + at) + wallZ;
    if constexpr (kSlows) {
        pace *= 1.0F + p.slowing * (weidmann(around) - 1.0F);
        // What density does to the pace is known; repulsion must not do it once more.
        const F8 wallsAhead = lesser(wallX * facingX + wallZ * facingZ, all(0.0F));
        const F8 eased =
            -p.slowing * (p.easedPeople * load(sums.backward + at) + p.easedWalls * wallsAhead);
        forceX += eased * facingX;
        forceZ += eased * facingZ;
    }
    const float perSecond = 1.0F / p.relaxationSeconds;
    const F8 beforeX = load(agents.velocityX.data() + row);
    const F8 beforeZ = load(agents.velocityZ.data() + row);
    forceX += (load(agents.desiredX.data() + row) * pace - beforeX) * perSecond;
    forceZ += (load(agents.desiredZ.data() + row) * pace - beforeZ) * perSecond;
    const F8 preferred = load(agents.preferredSpeed.data() + row);
    const I8 isBraking = preferred < 0.0F;
    F8 velocityX = isBraking ? beforeX : beforeX + forceX * job.seconds;
    F8 velocityZ = isBraking ? beforeZ : beforeZ + forceZ * job.seconds;
    const F8 speed = squareRoot(greater(squaredDistances(velocityX, velocityZ), all(kSmallest)));
    const F8 before =
        squareRoot(greater(squaredDistances(beforeX, beforeZ), all(kSmallest * kSmallest)));
    const F8 top = isBraking
                       ? greater(before + preferred * job.seconds, all(0.0F))
                       : greater(p.topSpeed * preferred, before - p.slowingDown * job.seconds);
    const F8 share = lesser(top / speed, all(1.0F));
    velocityX *= share;
    velocityZ *= share;
    const F8 atX = load(agents.x.data() + row);
    const F8 atZ = load(agents.z.data() + row);
    const F8 x = atX + velocityX * job.seconds;
    const F8 z = atZ + velocityZ * job.seconds;
    // Those who stand stay, and so does who would get nowhere.
    const F8 furthest = greater(greater(x, -x), greater(z, -z));
    const I8 isMoving = (preferred != 0.0F) & (x == x) & (z == z) & (furthest < 1e9F);
    storeSome(job.x + row, isMoving ? x : atX, lanes);
    storeSome(job.z + row, isMoving ? z : atZ, lanes);
    storeSome(job.velocityX + row, isMoving ? velocityX : all(0.0F), lanes);
    storeSome(job.velocityZ + row, isMoving ? velocityZ : all(0.0F), lanes);
    // Two may come closer by what both walk at most.
    const F8 least = 2.0F * job.seconds * greater(top, all(2.0F));
    const unsigned bits = bitsWhereLess(load(sums.closest + at), least) &
                          bitsWhereLess(all(0.0F), greater(preferred, -preferred));
    for (std::size_t l = 0; l < std::min(lanes, kLanes); ++l) {
        job.isCrowded[row + l] = static_cast<std::uint8_t>(bits >> l & 1U);
    }
}

template<bool kHasLevels, bool kSlows>
CROWD_INLINE void addPeople(const ForceJob& job, std::size_t begin, std::size_t count, Sums& sums)
{
    Neighbours near;
    BinLattice::Span spans[3];
    std::uint32_t bin = 0xFFFFFFFFU;
    std::size_t done = 0;
    while (done < count) {
        near.start[done] = 0;
        std::size_t i = done;
        for (; i < count && near.start[i] + kMostNeighbours <= kGathered - kLanes; ++i) {
            const std::size_t row = begin + i;
            if (job.lattice.binOfRow(row) != bin) {
                bin = job.lattice.binOfRow(row);
                job.lattice.neighbourhood(bin, spans);
            }
            near.start[i + 1] = collect<kHasLevels, kSlows>(job, row, spans, near, near.start[i]);
        }
        for (; done < i; ++done) {
            addNeighbours<kSlows>(job, begin + done, near, sums, done);
        }
    }
}

CROWD_INLINE BodyPlace placeOf(const ForceJob& job, std::size_t row)
{
    return {job.agents.x[row], job.agents.z[row], job.agents.y[row], job.agents.radius[row]};
}

inline void addWalls(const ForceJob& job, std::size_t begin, std::size_t count, Sums& sums)
{
    for (std::size_t i = 0; i < count; ++i) {
        const WallPull pull = wallPull(job.walls, job.parameters, placeOf(job, begin + i));
        sums.wallX[i] = pull.x;
        sums.wallZ[i] = pull.z;
        sums.hidden[i] = pull.hidden;
    }
}

template<bool kHasLevels, bool kSlows>
void advance(const ForceJob& job, std::size_t begin, std::size_t end)
{
    Sums sums;
    for (std::size_t first = begin; first < end; first += kBatch) {
        const std::size_t count = std::min(kBatch, end - first);
        addPeople<kHasLevels, kSlows>(job, first, count, sums);
        if (!job.walls.isEmpty()) {
            addWalls(job, first, count, sums);
        }
        for (std::size_t i = 0; i < count; i += kLanes) {
            moveBlock<kSlows>(job, first + i, count - i, sums, i);
        }
        for (std::size_t row = first; row < first + count && !job.walls.isEmpty(); ++row) {
            if (job.agents.preferredSpeed[row] != 0.0F) {
                keepOutOfWalls(job.walls, placeOf(job, row), job.x[row], job.z[row]);
            }
        }
    }
}

/// Way of one row out of those too close to it; false: none is.
template<bool kHasLevels>
CROWD_INLINE bool wayOut(const ForceJob& job, std::size_t row, float& wayX, float& wayZ)
{
    const AgentColumns& agents = job.agents;
    const float share = job.parameters.closest;
    BinLattice::Span spans[3];
    job.lattice.neighbourhood(job.lattice.binOfRow(row), spans);
    bool isClose = false;
    for (const BinLattice::Span& span : spans) {
        for (std::size_t first = span.begin; first < span.end; first += kLanes) {
            const F8 x = agents.x[row] - load(agents.x.data() + first);
            const F8 z = agents.z[row] - load(agents.z.data() + first);
            const F8 least = share * (agents.radius[row] + load(agents.radius.data() + first));
            F8 squared = squaredDistances(x, z);
            if constexpr (kHasLevels) {
                const F8 above = load(agents.y.data() + first) - agents.y[row];
                squared += greater(above, -above) > kLevelMetres ? all(1e12F) : all(0.0F);
            }
            unsigned bits =
                bitsWhereLess(squared, least * least) & bitsOfOthers(first, span.end, row);
            for (; bits != 0; bits &= bits - 1) {
                const auto l = static_cast<std::size_t>(std::countr_zero(bits));
                isClose = true;
                leave(agents, row, first + l, least[l], wayX, wayZ);
            }
        }
    }
    return isClose;
}

template<bool kHasLevels>
std::size_t separate(const ForceJob& job, std::size_t begin, std::size_t end)
{
    std::copy(job.agents.x.data() + begin, job.agents.x.data() + end, job.x + begin);
    std::copy(job.agents.z.data() + begin, job.agents.z.data() + end, job.z + begin);
    std::size_t moved = 0;
    for (std::size_t row = begin; row < end; ++row) {
        float wayX = 0.0F;
        float wayZ = 0.0F;
        if (job.isCrowded[row] == 0 || !wayOut<kHasLevels>(job, row, wayX, wayZ)) {
            continue;
        }
        ++moved;
        job.x[row] += wayX;
        job.z[row] += wayZ;
        keepOutOfWalls(job.walls, placeOf(job, row), job.x[row], job.z[row]);
    }
    return moved;
}

/// Unit vectors of where everybody wants to go; zero: nowhere.
CROWD_INLINE void face(const AgentColumns& agents, std::size_t begin, std::size_t end,
                       float* facingX, float* facingZ)
{
    const float* __restrict__ wishX = agents.desiredX.data();
    const float* __restrict__ wishZ = agents.desiredZ.data();
    float* __restrict__ toX = facingX;
    float* __restrict__ toZ = facingZ;
    for (std::size_t row = begin; row < end; ++row) {
        const float squared = wishX[row] * wishX[row] + wishZ[row] * wishZ[row];
        const float perWish = squared > kSmallest ? 1.0F / std::sqrt(squared) : 0.0F;
        toX[row] = wishX[row] * perWish;
        toZ[row] = wishZ[row] * perWish;
    }
}

#undef CROWD_INLINE
