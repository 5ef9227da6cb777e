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

/// True in as many of the first lanes.
CROWD_INLINE I8 lanesBelow(std::size_t count)
{
    return I8{0, 1, 2, 3, 4, 5, 6, 7} < static_cast<std::int32_t>(count);
}

/// Far away for those who are no neighbours of a row, wherever they are: on another level, or of
/// the same body.
template<Crowd kCrowd>
CROWD_INLINE F8 farIfApart(const AgentRows& agents, std::size_t row, std::size_t first)
{
    F8 away{};
    if constexpr (kCrowd != Crowd::Flat) {
        const F8 above = load(agents.y.data() + first) - agents.y[row];
        away += greater(above, -above) > kLevelMetres ? all(1e12F) : all(0.0F);
    }
    if constexpr (kCrowd == Crowd::Long) {
        const I8 owners = *reinterpret_cast<const I8InMemory*>(agents.owner.data() + first);
        away += owners == agents.owner[row] ? all(1e12F) : all(0.0F);
    }
    return away;
}

/// Rows of everybody within range of a row, ascending, from near.row[at] on; returns where the next
/// row's begin.
template<Crowd kCrowd>
CROWD_INLINE std::size_t collect(const ForceJob& job, std::size_t row,
                                 const BinLattice::Span (&spans)[3], Neighbours& near,
                                 std::size_t at)
{
    const std::size_t most = at + kMostNeighbours - kLanes;
    const AgentRows& agents = job.agents;
    const F8 selfX = all(agents.x[row]);
    const F8 selfZ = all(agents.z[row]);
    const F8 squaredRange = all(job.reach * job.reach);
    std::size_t count = at;
    for (const BinLattice::Span& span : spans) {
        for (std::size_t first = span.begin; first < span.end; first += kLanes) {
            const F8 x = selfX - load(agents.x.data() + first);
            const F8 z = selfZ - load(agents.z.data() + first);
            F8 squared = squaredDistances(x, z);
            if constexpr (kCrowd != Crowd::Flat) {
                squared += farIfApart<kCrowd>(agents, row, first);
            }
            const unsigned bits =
                bitsWhereLess(squared, squaredRange) & bitsOfOthers(first, span.end, row);
            listBits(bits, static_cast<std::uint32_t>(first), near.row + count);
            count = std::min(count + static_cast<std::size_t>(std::popcount(bits)), most);
        }
    }
    return count;
}

// What neighbours do is reckoned in several short loops over the neighbours of many rows, since in
// a short loop the processor works on many of them at once; in one long loop the roots, divisions
// and exponentials of each would wait for each other.

/// Neighbours of a row as seen from there. Those of all rows lie next to each other without gaps:
/// what is written beyond a row's is put right by the next.
template<bool kSlows>
CROWD_INLINE void meet(const ForceJob& job, std::size_t row, Neighbours& near, std::size_t at)
{
    const ForceParameters& p = job.parameters;
    const Seen& self = job.agents.seen[row];
    const std::size_t end = near.start[at + 1];
    for (std::size_t first = near.start[at]; first < end; first += kLanes) {
        const float* records[kLanes];
        for (std::size_t i = 0; i < kLanes; ++i) {
            records[i] = &job.agents.seen[near.row[first + i]].x;
        }
        F8 other[kLanes]; // in the order of Seen
        transpose(records, other);
        const F8 x = self.x - other[0];
        const F8 z = self.z - other[1];
        const F8 velocityX = self.velocityX - other[2];
        const F8 velocityZ = self.velocityZ - other[3];
        const F8 stepX = velocityX * p.anticipationSeconds;
        const F8 stepZ = velocityZ * p.anticipationSeconds;
        const F8 soonX = x + stepX;
        const F8 soonZ = z + stepZ;
        store(near.x + first, x);
        store(near.z + first, z);
        store(near.soonX + first, soonX);
        store(near.soonZ + first, soonZ);
        store(near.squaredStep + first, squaredDistances(stepX, stepZ));
        store(near.parting + first, velocityX * x + velocityZ * z);
        store(near.radius + first, self.radius + other[4]);
        store(near.ahead + first, -(x * self.facingX + z * self.facingZ));
        if constexpr (kSlows) {
            const F8 against = -(other[5] * self.facingX + other[6] * self.facingZ);
            store(near.counted + first, 1.0F - p.oncoming * greater(against, all(0.0F)));
            store(near.soonAhead + first, -(soonX * self.facingX + soonZ * self.facingZ));
        }
    }
}

/// How far away they are now and soon, and the ellipse around both.
CROWD_INLINE void measure(const ForceParameters& p, Neighbours& near, std::size_t end)
{
    for (std::size_t i = 0; i < end; i += kLanes) {
        const F8 distance = squareRoot(
            greater(squaredDistances(load(near.x + i), load(near.z + i)), all(kSmallest)));
        const F8 soon = squareRoot(
            greater(squaredDistances(load(near.soonX + i), load(near.soonZ + i)), all(kSmallest)));
        const F8 sum = distance + soon;
        const F8 squaredAxis =
            greater(sum * sum - load(near.squaredStep + i), all(p.leastAxis * p.leastAxis));
        store(near.distance + i, distance);
        store(near.soon + i, soon);
        store(near.axis + i, squareRoot(squaredAxis));
    }
}

/// Repulsion and contact of each, in place of what they are made of.
template<bool kSlows>
CROWD_INLINE void press(const ForceJob& job, Neighbours& near, std::size_t end)
{
    const ForceParameters& p = job.parameters;
    const float perReach = -0.5F / p.reach;
    const float perSquare = 1.0F / (p.range * p.range);
    const float blind = 0.5F * (1.0F - p.fromBehind);
    for (std::size_t i = 0; i < end; i += kLanes) {
        const F8 distance = load(near.distance + i);
        const F8 soon = load(near.soon + i);
        const F8 axis = load(near.axis + i); // twice the short half-axis of the ellipse
        // One division for all three: they are what takes longest.
        const F8 both = distance * soon;
        const F8 perAll = 1.0F / (both * axis);
        const F8 perDistance = perAll * (soon * axis);
        const F8 perSoon = perAll * (distance * axis);
        const F8 perAxis = perAll * both;
        const F8 unitX = load(near.x + i) * perDistance;
        const F8 unitZ = load(near.z + i) * perDistance;
        const F8 ahead = load(near.ahead + i) * perDistance;
        const F8 seen = p.fromBehind + blind * (1.0F + ahead);
        // Between wide bodies it is the same room that counts, not the same distance.
        const F8 radius = load(near.radius + i);
        const F8 wider = radius - kPersonRadii;
        const F8 room = greater(distance - wider, all(0.0F));
        const F8 nearness = greater(1.0F - room * room * perSquare, all(0.0F));
        const F8 push = nearness * seen * ((distance + soon) * perAxis) * (0.5F * p.strength) *
                        exponential(greater(axis - 2.0F * wider, all(0.0F)) * perReach);
        const F8 touch = p.contact * greater(radius - distance, all(0.0F));
        F8 presence = nearness * nearness * (1.0F + ahead);
        if constexpr (kSlows) {
            const F8 counted = load(near.counted + i);
            const F8 forward = -(load(near.soonAhead + i) * perSoon + ahead);
            store(near.soonAhead + i, push * lesser(forward, all(0.0F)) * counted);
            presence *= counted;
        }
        store(near.x + i, push * (unitX + load(near.soonX + i) * perSoon) + touch * unitX);
        store(near.z + i, push * (unitZ + load(near.soonZ + i) * perSoon) + touch * unitZ);
        store(near.counted + i, presence);
        const F8 then = distance + load(near.parting + i) * perDistance * job.seconds;
        store(near.radius + i, then - p.closest * radius);
    }
}

template<bool kSlows>
CROWD_INLINE void total(const Neighbours& near, Sums& sums, std::size_t at)
{
    F8 x{};
    F8 z{};
    F8 backward{};
    F8 presence{};
    F8 closest = all(1e3F);
    const std::size_t end = near.start[at + 1];
    for (std::size_t first = near.start[at]; first < end; first += kLanes) {
        const I8 isMet = lanesBelow(end - first);
        const auto ofMet = [ isMet, first ](const float* column) __attribute__((always_inline))
        {
            return isMet ? load(column + first) : F8{};
        };
        x += ofMet(near.x);
        z += ofMet(near.z);
        presence += ofMet(near.counted);
        closest = lesser(closest, isMet ? load(near.radius + first) : closest);
        if constexpr (kSlows) {
            backward += ofMet(near.soonAhead);
        }
    }
    const F4 all = sumsOf(x, z, backward, presence);
    sums.x[at] = all[0];
    sums.z[at] = all[1];
    sums.backward[at] = all[2];
    sums.density[at] = all[3];
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

struct Push
{
    F8 x;
    F8 z;
};

/// Metres per second², on a block of rows: of others, of walls, and of each one's own wish to go
/// on.
template<bool kSlows>
CROWD_INLINE Push pushOn(const ForceJob& job, std::size_t row, const F8 (&self)[kLanes],
                         const Sums& sums, std::size_t at)
{
    const ForceParameters& p = job.parameters;
    const auto& [atX, atZ, beforeX, beforeZ, radius, facingX, facingZ, preferred] = self;
    const F8 desiredSpeed = load(job.agents.desiredSpeed.data() + row);
    // The mean over a disk of the nearness is a third of it.
    const float perDisk = 1.0F / (3.14159265F / 3.0F * p.range * p.range);
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
    forceX += (facingX * (desiredSpeed * pace) - beforeX) * perSecond;
    forceZ += (facingZ * (desiredSpeed * pace) - beforeZ) * perSecond;
    return {forceX, forceZ};
}

/// Velocity and place of a block of rows after the step, walls apart. Returns how far each got away
/// from the way that it was on.
template<bool kSlows>
CROWD_INLINE F8 moveBlock(const ForceJob& job, std::size_t row, std::size_t lanes, const Sums& sums,
                          std::size_t at)
{
    const ForceParameters& p = job.parameters;
    const float* records[kLanes];
    for (std::size_t i = 0; i < kLanes; ++i) {
        records[i] = &job.agents.seen[row + i].x;
    }
    F8 self[kLanes]; // in the order of Seen
    transpose(records, self);
    const auto& [atX, atZ, beforeX, beforeZ, radius, facingX, facingZ, preferred] = self;
    const auto [forceX, forceZ] = pushOn<kSlows>(job, row, self, sums, at);
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
    const F8 x = atX + velocityX * job.seconds;
    const F8 z = atZ + velocityZ * job.seconds;
    // Those who stand stay, and so does who would get nowhere.
    const F8 furthest = greater(greater(x, -x), greater(z, -z));
    const I8 isMoving = (preferred != 0.0F) & (x == x) & (z == z) & (furthest < 1e9F);
    const F8 motion[4] = {isMoving ? x : atX, isMoving ? z : atZ, isMoving ? velocityX : all(0.0F),
                          isMoving ? velocityZ : all(0.0F)};
    storeSome(job.x + row, motion[0], lanes);
    storeSome(job.z + row, motion[1], lanes);
    storeSome(job.velocityX + row, motion[2], lanes);
    storeSome(job.velocityZ + row, motion[3], lanes);
    const F8 aside =
        squareRoot(squaredDistances(motion[2] - beforeX, motion[3] - beforeZ)) * job.seconds;
    const I8 isThere = lanesBelow(lanes);
    storeSome(job.slack + row, preferred != 0.0F ? load(sums.closest + at) - aside : all(kAnyReach),
              lanes);
    return isThere ? aside : all(0.0F);
}

template<Crowd kCrowd, bool kSlows>
CROWD_INLINE void addPeople(const ForceJob& job, std::size_t begin, std::size_t count, Sums& sums)
{
    Neighbours near;
    BinLattice::Span spans[3];
    BinLattice::Line line;
    std::uint32_t bin = 0xFFFFFFFFU;
    std::size_t done = 0;
    while (done < count) {
        near.start[done] = 0;
        std::size_t i = done;
        for (; i < count && near.start[i] + kMostNeighbours <= kGathered; ++i) {
            const std::size_t row = begin + i;
            if (job.lattice.binOfRow(row) != bin) {
                bin = job.lattice.binOfRow(row);
                job.lattice.neighbourhood(bin, line, spans);
            }
            near.start[i + 1] = collect<kCrowd>(job, row, spans, near, near.start[i]);
        }
        // The last block is filled up with anybody.
        std::fill_n(near.row + near.start[i], kLanes, static_cast<std::uint32_t>(begin));
        for (std::size_t met = done; met < i; ++met) {
            meet<kSlows>(job, begin + met, near, met);
        }
        measure(job.parameters, near, near.start[i]);
        press<kSlows>(job, near, near.start[i]);
        for (; done < i; ++done) {
            total<kSlows>(near, sums, done);
        }
    }
}

CROWD_INLINE BodyPlace placeOf(const ForceJob& job, std::size_t row)
{
    return {job.agents.x[row], job.agents.z[row], job.agents.y[row], job.agents.seen[row].radius};
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

/// Rows of a batch out of the walls they got into; how far at most.
inline float keepOut(const ForceJob& job, std::size_t begin, std::size_t end)
{
    float furthest = 0.0F;
    for (std::size_t row = begin; row < end; ++row) {
        if (job.agents.seen[row].preferredSpeed == 0.0F) {
            continue;
        }
        const float x = job.x[row];
        const float z = job.z[row];
        keepOutOfWalls(job.walls, placeOf(job, row), job.seconds, job.x[row], job.z[row]);
        if (job.x[row] != x || job.z[row] != z) {
            const float away = flatLength(job.x[row] - x, job.z[row] - z);
            job.slack[row] -= away;
            furthest = std::max(furthest, away);
        }
    }
    return furthest;
}

template<Crowd kCrowd, bool kSlows>
float advance(const ForceJob& job, std::size_t begin, std::size_t end)
{
    Sums sums;
    F8 aside{};
    float outOfWalls = 0.0F;
    for (std::size_t first = begin; first < end; first += kBatch) {
        const std::size_t count = std::min(kBatch, end - first);
        addPeople<kCrowd, kSlows>(job, first, count, sums);
        if (!job.walls.isEmpty()) {
            addWalls(job, first, count, sums);
        }
        for (std::size_t i = 0; i < count; i += kLanes) {
            aside = greater(aside, moveBlock<kSlows>(job, first + i, count - i, sums, i));
        }
        if (!job.walls.isEmpty()) {
            outOfWalls = std::max(outOfWalls, keepOut(job, first, first + count));
        }
    }
    return -leastOf(-aside) + outOfWalls;
}

CROWD_INLINE F8 radii(const Seen* seen)
{
    F8 radius;
    for (std::size_t l = 0; l < kLanes; ++l) {
        radius[l] = seen[l].radius;
    }
    return radius;
}

/// Way of one row out of those too close to it; false: none is.
template<Crowd kCrowd>
CROWD_INLINE bool wayOut(const ForceJob& job, std::size_t row, float& wayX, float& wayZ)
{
    const AgentRows& agents = job.agents;
    const float share = job.parameters.closest;
    BinLattice::Span spans[3];
    BinLattice::Line line;
    job.lattice.neighbourhood(job.lattice.binOfRow(row), line, spans);
    std::size_t close = 0;
    for (const BinLattice::Span& span : spans) {
        for (std::size_t first = span.begin; first < span.end && close < kMostClose;
             first += kLanes) {
            const F8 x = agents.x[row] - load(agents.x.data() + first);
            const F8 z = agents.z[row] - load(agents.z.data() + first);
            const F8 least = share * (agents.seen[row].radius + radii(&agents.seen[first]));
            F8 squared = squaredDistances(x, z);
            if constexpr (kCrowd != Crowd::Flat) {
                squared += farIfApart<kCrowd>(agents, row, first);
            }
            unsigned bits =
                bitsWhereLess(squared, least * least) & bitsOfOthers(first, span.end, row);
            for (; bits != 0 && close < kMostClose; bits &= bits - 1, ++close) {
                const auto l = static_cast<std::size_t>(std::countr_zero(bits));
                leave(agents, row, first + l, least[l], wayX, wayZ);
            }
        }
    }
    return close > 0;
}

template<Crowd kCrowd>
Separated separate(const ForceJob& job, std::size_t begin, std::size_t end, float reach,
                   std::uint32_t* moved)
{
    Separated separated;
    for (std::size_t first = begin; first < end; first += kLanes) {
        unsigned bits =
            bitsWhereLess(load(job.slack + first), all(reach)) & bitsOfOthers(first, end, end);
        for (; bits != 0; bits &= bits - 1) {
            const std::size_t row = first + static_cast<std::size_t>(std::countr_zero(bits));
            float wayX = 0.0F;
            float wayZ = 0.0F;
            if (!wayOut<kCrowd>(job, row, wayX, wayZ)) {
                continue;
            }
            const float length = flatLength(wayX, wayZ);
            const float part = length > kFarthestApart ? kFarthestApart / length : 1.0F;
            job.x[row] = job.agents.x[row] + wayX * part;
            job.z[row] = job.agents.z[row] + wayZ * part;
            keepOutOfWalls(job.walls, placeOf(job, row), job.seconds, job.x[row], job.z[row]);
            const float away =
                flatLength(job.x[row] - job.agents.x[row], job.z[row] - job.agents.z[row]);
            job.slack[row] -= away;
            separated.furthest = std::max(separated.furthest, away);
            moved[separated.count++] = static_cast<std::uint32_t>(row);
        }
    }
    return separated;
}

inline void gather(const Body* bodies, const std::uint32_t* agentOfRow, AgentRows& rows,
                   std::size_t begin, std::size_t end)
{
    for (std::size_t row = begin; row < end; row += kLanes) {
        const std::size_t lanes = std::min(kLanes, end - row);
        const float* records[kLanes];
        for (std::size_t i = 0; i < kLanes; ++i) {
            records[i] = &bodies[agentOfRow[row + std::min(i, lanes - 1)]].x;
        }
        F8 body[kLanes]; // in the order of Body
        transpose(records, body);
        const auto& [x, z, velocityX, velocityZ, desiredX, desiredZ, preferred, radius] = body;
        storeSome(rows.x.data() + row, x, lanes);
        storeSome(rows.z.data() + row, z, lanes);
        const F8 squared = squaredDistances(desiredX, desiredZ);
        const F8 speed = squareRoot(greater(squared, all(kSmallest)));
        const F8 perSpeed = squared > kSmallest ? 1.0F / speed : F8{};
        const F8 facingX = desiredX * perSpeed;
        const F8 facingZ = desiredZ * perSpeed;
        storeSome(rows.desiredSpeed.data() + row, speed, lanes);
        const F8 seen[kLanes] = {x,      z,       velocityX, velocityZ,
                                 radius, facingX, facingZ,   preferred}; // in the order of Seen
        const float* parts[kLanes];
        for (std::size_t i = 0; i < kLanes; ++i) {
            parts[i] = reinterpret_cast<const float*>(&seen[i]);
        }
        F8 seenBy[kLanes];
        transpose(parts, seenBy);
        for (std::size_t i = 0; i < lanes; ++i) {
            store(&rows.seen[row + i].x, seenBy[i]);
        }
    }
}

#undef CROWD_INLINE
