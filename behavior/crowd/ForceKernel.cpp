// SPDX-License-Identifier: MIT
#include "behavior/crowd/ForceKernel.h"

#include <algorithm>
#include <cmath>

#include "behavior/crowd/FastExp.h"

// A clone of each hot function per instruction set, chosen when the program is loaded. The choice
// happens before a sanitizer is ready, and clang does not know the name of the set.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) &&                             \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CROWD_CLONES __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define CROWD_CLONES
#endif

namespace crowd::behavior {

namespace {

/// More than fit around anybody who has not been walked into; the rest is not noticed.
constexpr std::size_t kMostNeighbours = 256;
constexpr float kSmallest = 1e-6F;

/// Those within range of one agent, as seen from there; padded to whole blocks of lanes with
/// somebody so far away that he has no effect.
struct Neighbours
{
    float x[kMostNeighbours + kLanes]; ///< own position minus theirs
    float z[kMostNeighbours + kLanes];
    float velocityX[kMostNeighbours + kLanes]; ///< own velocity minus theirs
    float velocityZ[kMostNeighbours + kLanes];
    float radius[kMostNeighbours + kLanes];
    std::size_t count = 0;
};

/// Sums over neighbours, one per lane.
struct Lanes
{
    float x[kLanes] = {};
    float z[kLanes] = {};
    float backward[kLanes] = {}; ///< repulsion against the way one faces
    float density[kLanes] = {};
    float closest[kLanes];
};

struct Body
{
    float x;
    float z;
    float y;
    float velocityX;
    float velocityZ;
    float facingX; ///< unit, where it wants to go; zero: nowhere
    float facingZ;
    float radius;
};

[[gnu::always_inline]] inline float sumOf(const float (&lanes)[kLanes])
{
    return ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) +
           ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]));
}

[[gnu::always_inline]] inline float leastOf(const float (&lanes)[kLanes])
{
    float least = lanes[0];
    for (std::size_t l = 1; l < kLanes; ++l) {
        least = std::min(least, lanes[l]);
    }
    return least;
}

/// Squared distances of a block of rows; people on another level are far away.
template<bool kHasLevels>
[[gnu::always_inline]] inline void distances(const AgentColumns& agents, const Body& self,
                                             std::size_t row, float (&squared)[kLanes])
{
    const float* x = agents.x.data() + row;
    const float* z = agents.z.data() + row;
    const float* y = agents.y.data() + row;
    for (std::size_t l = 0; l < kLanes; ++l) {
        const float awayX = self.x - x[l];
        const float awayZ = self.z - z[l];
        squared[l] = awayX * awayX + awayZ * awayZ;
        if constexpr (kHasLevels) {
            squared[l] += std::fabs(self.y - y[l]) > kLevelMetres ? 1e12F : 0.0F;
        }
    }
}

/// Rows within range, in order of rows, without `self` itself.
template<bool kHasLevels>
[[gnu::always_inline]] inline std::size_t
rowsInRange(const AgentColumns& agents, const Body& self, std::size_t selfRow,
            const BinLattice::Span (&spans)[3], float squaredRange, std::uint32_t* found)
{
    std::size_t count = 0;
    for (const BinLattice::Span& span : spans) {
        for (std::size_t row = span.begin; row < span.end; row += kLanes) {
            float squared[kLanes];
            distances<kHasLevels>(agents, self, row, squared);
            const std::size_t lanes = std::min(kLanes, span.end - row);
            for (std::size_t l = 0; l < lanes; ++l) {
                found[count] = static_cast<std::uint32_t>(row + l);
                const bool isIn = (squared[l] < squaredRange) & (row + l != selfRow);
                count += static_cast<std::size_t>(isIn);
            }
            count = std::min(count, kMostNeighbours - kLanes);
        }
    }
    return count;
}

[[gnu::always_inline]] inline void gather(const AgentColumns& agents, const Body& self,
                                          const std::uint32_t* rows, std::size_t count,
                                          Neighbours& near)
{
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t row = rows[i];
        near.x[i] = self.x - agents.x[row];
        near.z[i] = self.z - agents.z[row];
        near.velocityX[i] = self.velocityX - agents.velocityX[row];
        near.velocityZ[i] = self.velocityZ - agents.velocityZ[row];
        near.radius[i] = self.radius + agents.radius[row];
    }
    for (std::size_t i = count; i < count + kLanes; ++i) {
        near.x[i] = 1e3F;
        near.z[i] = 1e3F;
        near.velocityX[i] = 0.0F;
        near.velocityZ[i] = 0.0F;
        near.radius[i] = 0.0F;
    }
    near.count = count;
}

/// Repulsion and contact of one block of neighbours.
[[gnu::always_inline]] inline void addBlock(const Neighbours& near, std::size_t first,
                                            const Body& self, const ForceParameters& p, Lanes& sums)
{
    const float perReach = -0.5F / p.reach;
    const float perSquare = 1.0F / (p.range * p.range);
    const float blind = 0.5F * (1.0F - p.fromBehind);
    for (std::size_t l = 0; l < kLanes; ++l) {
        const float x = near.x[first + l];
        const float z = near.z[first + l];
        const float stepX = near.velocityX[first + l] * p.anticipationSeconds;
        const float stepZ = near.velocityZ[first + l] * p.anticipationSeconds;
        const float squared = std::max(x * x + z * z, kSmallest);
        const float distance = std::sqrt(squared);
        const float perDistance = 1.0F / distance;
        const float soonX = x + stepX;
        const float soonZ = z + stepZ;
        const float soon = std::sqrt(std::max(soonX * soonX + soonZ * soonZ, kSmallest));
        const float perSoon = 1.0F / soon;
        const float sum = distance + soon;
        // Twice the short half-axis of the ellipse.
        const float axis = std::sqrt(
            std::max(sum * sum - (stepX * stepX + stepZ * stepZ), p.leastAxis * p.leastAxis));
        const float unitX = x * perDistance;
        const float unitZ = z * perDistance;
        const float ahead = -(unitX * self.facingX + unitZ * self.facingZ);
        const float seen = p.fromBehind + blind * (1.0F + ahead);
        const float nearness = std::max(1.0F - squared * perSquare, 0.0F);
        const float push =
            nearness * seen * p.strength * fastExp(axis * perReach) * sum / (2.0F * axis);
        const float touch = p.contact * std::max(near.radius[first + l] - distance, 0.0F);
        sums.x[l] += push * (unitX + soonX * perSoon) + touch * unitX;
        sums.z[l] += push * (unitZ + soonZ * perSoon) + touch * unitZ;
        const float forward =
            push * (-ahead + (soonX * self.facingX + soonZ * self.facingZ) * perSoon);
        sums.backward[l] += std::min(forward, 0.0F);
        sums.density[l] += nearness * nearness * (1.0F + ahead);
        const float room = distance - p.closest * near.radius[first + l];
        sums.closest[l] = std::min(sums.closest[l], room);
    }
}

struct Pull
{
    float x = 0.0F;
    float z = 0.0F;
    float hidden = 0.0F; ///< share of what one sees around that lies behind walls
};

[[gnu::always_inline]] inline Pull wallForce(const ForceJob& job, const Body& self)
{
    const ForceParameters& p = job.parameters;
    Pull pull;
    for (const std::uint32_t index : job.walls.near(self.x, self.z)) {
        const WallPiece& piece = job.walls.piece(index);
        float awayX = 0.0F;
        float awayZ = 0.0F;
        if (self.y < piece.low || self.y > piece.high ||
            !awayFrom(piece, self.x, self.z, awayX, awayZ)) {
            continue;
        }
        const float distance = std::sqrt(std::max(awayX * awayX + awayZ * awayZ, kSmallest));
        const float gap = self.radius - distance;
        // Someone inside a wall is pushed out firmly, not shot out.
        const float push = p.wallStrength * fastExp(std::min(gap, 0.0F) / p.wallReach) +
                           p.wallContact * std::max(gap, 0.0F);
        pull.x += push * awayX / distance;
        pull.z += push * awayZ / distance;
        const float inside = std::max(1.0F - distance / p.range, 0.0F);
        pull.hidden += 0.5F * inside * inside;
    }
    return pull;
}

/// Walking speed among so many per square metre, as a share of the free one (Weidmann 1993).
[[gnu::always_inline]] inline float weidmann(float perSquareMetre)
{
    constexpr float kJam = 5.4F;
    const float room = 1.0F / std::max(perSquareMetre, 0.01F) - 1.0F / kJam;
    return 1.0F - fastExp(-1.913F * std::max(room, 0.01F));
}

/// Where a body may stand that wants to be at (x, z): out of the walls it touches.
[[gnu::always_inline]] inline void keepOutOfWalls(const ForceJob& job, const Body& self, float& x,
                                                  float& z)
{
    for (const std::uint32_t index : job.walls.near(x, z)) {
        const WallPiece& piece = job.walls.piece(index);
        float awayX = 0.0F;
        float awayZ = 0.0F;
        if (self.y < piece.low || self.y > piece.high || !awayFrom(piece, x, z, awayX, awayZ)) {
            continue;
        }
        const float squared = awayX * awayX + awayZ * awayZ;
        if (squared < self.radius * self.radius && squared > kSmallest) {
            const float further = self.radius / std::sqrt(squared) - 1.0F;
            x += awayX * further;
            z += awayZ * further;
        }
    }
    // Whoever was squeezed through a wall stays where he was.
    for (const std::uint32_t index : job.walls.near(self.x, self.z)) {
        const WallPiece& piece = job.walls.piece(index);
        if (piece.length == 0.0F || self.y < piece.low || self.y > piece.high) {
            continue;
        }
        const float normalX = -piece.along.y;
        const float normalZ = piece.along.x;
        const float before = (self.x - piece.at.x) * normalX + (self.z - piece.at.y) * normalZ;
        const float after = (x - piece.at.x) * normalX + (z - piece.at.y) * normalZ;
        if ((before > 0.0F) == (after > 0.0F)) {
            continue;
        }
        const float share = before / (before - after);
        const float crossX = self.x + (x - self.x) * share - piece.at.x;
        const float crossZ = self.z + (z - self.z) * share - piece.at.y;
        const float along = crossX * piece.along.x + crossZ * piece.along.y;
        if (along >= 0.0F && along <= piece.length) {
            x = self.x;
            z = self.z;
            return;
        }
    }
}

[[gnu::always_inline]] inline Body bodyOf(const AgentColumns& agents, std::size_t row)
{
    const float wishX = agents.desiredX[row];
    const float wishZ = agents.desiredZ[row];
    const float squared = wishX * wishX + wishZ * wishZ;
    const float perWish = squared > kSmallest ? 1.0F / std::sqrt(squared) : 0.0F;
    return {agents.x[row],         agents.z[row],   agents.y[row],   agents.velocityX[row],
            agents.velocityZ[row], wishX * perWish, wishZ * perWish, agents.radius[row]};
}

/// Velocity and place after the step.
[[gnu::always_inline]] inline void move(const ForceJob& job, std::size_t row, const Body& self,
                                        const Lanes& sums)
{
    const ForceParameters& p = job.parameters;
    const Pull walls = wallForce(job, self);
    // The mean over a disk of the nearness is a third of it.
    const float disk = 3.14159265F / 3.0F * p.range * p.range;
    const float visible = std::max(1.0F - walls.hidden, 0.3F);
    const float around = sumOf(sums.density) / (disk * visible);
    // Nobody presses on where there is no room at all.
    const float room = std::clamp((p.jam - around) * 0.5F, 0.0F, 1.0F);
    const float pace = room * (1.0F + p.slowing * (weidmann(around) - 1.0F));
    const float perSecond = 1.0F / p.relaxationSeconds;
    // What density does to the pace is known; repulsion must not do it once more.
    const float wallsAhead = std::min(walls.x * self.facingX + walls.z * self.facingZ, 0.0F);
    const float eased =
        -p.slowing * (p.easedPeople * sumOf(sums.backward) + p.easedWalls * wallsAhead);
    const float pushX = (job.agents.desiredX[row] * pace - self.velocityX) * perSecond;
    const float pushZ = (job.agents.desiredZ[row] * pace - self.velocityZ) * perSecond;
    float velocityX =
        self.velocityX + (pushX + sumOf(sums.x) + eased * self.facingX + walls.x) * job.seconds;
    float velocityZ =
        self.velocityZ + (pushZ + sumOf(sums.z) + eased * self.facingZ + walls.z) * job.seconds;
    const float speed = std::sqrt(velocityX * velocityX + velocityZ * velocityZ);
    const float top = p.topSpeed * job.agents.preferredSpeed[row];
    if (speed > top) {
        velocityX *= top / speed;
        velocityZ *= top / speed;
    }
    float x = self.x + velocityX * job.seconds;
    float z = self.z + velocityZ * job.seconds;
    if (!(std::fabs(x) < 1e9F && std::fabs(z) < 1e9F)) {
        x = self.x;
        z = self.z;
        velocityX = 0.0F;
        velocityZ = 0.0F;
    }
    keepOutOfWalls(job, self, x, z);
    job.x[row] = x;
    job.z[row] = z;
    job.velocityX[row] = velocityX;
    job.velocityZ[row] = velocityZ;
    // Two may come closer by what both walk at most.
    const float nearest = leastOf(sums.closest);
    job.isCrowded[row] = nearest < 2.0F * job.seconds * std::max(top, 2.0F) ? 1 : 0;
}

[[gnu::always_inline]] inline void stay(const ForceJob& job, std::size_t row)
{
    job.x[row] = job.agents.x[row];
    job.z[row] = job.agents.z[row];
    job.velocityX[row] = 0.0F;
    job.velocityZ[row] = 0.0F;
    job.isCrowded[row] = 0;
}

template<bool kHasLevels>
[[gnu::always_inline]] inline void advance(const ForceJob& job, std::size_t begin, std::size_t end)
{
    const float squaredRange = job.parameters.range * job.parameters.range;
    std::uint32_t rows[kMostNeighbours + kLanes];
    Neighbours near;
    BinLattice::Span spans[3];
    std::uint32_t bin = 0xFFFFFFFFU;
    for (std::size_t row = begin; row < end; ++row) {
        if (job.agents.preferredSpeed[row] <= 0.0F) {
            stay(job, row);
            continue;
        }
        if (job.lattice.binOfRow(row) != bin) {
            bin = job.lattice.binOfRow(row);
            job.lattice.neighbourhood(bin, spans);
        }
        const Body self = bodyOf(job.agents, row);
        const std::size_t count =
            rowsInRange<kHasLevels>(job.agents, self, row, spans, squaredRange, rows);
        gather(job.agents, self, rows, count, near);
        Lanes sums;
        std::fill_n(sums.closest, kLanes, 1e3F);
        for (std::size_t first = 0; first < count; first += kLanes) {
            addBlock(near, first, self, job.parameters, sums);
        }
        move(job, row, self, sums);
    }
}

/// Way of one row out of those too close to it; false: none is.
template<bool kHasLevels>
[[gnu::always_inline]] inline bool wayOut(const ForceJob& job, std::size_t row, const Body& self,
                                          const BinLattice::Span (&spans)[3], float& wayX,
                                          float& wayZ)
{
    const AgentColumns& agents = job.agents;
    bool isClose = false;
    for (const BinLattice::Span& span : spans) {
        for (std::size_t other = span.begin; other < span.end; ++other) {
            const float x = self.x - agents.x[other];
            const float z = self.z - agents.z[other];
            const float least = job.parameters.closest * (self.radius + agents.radius[other]);
            const float squared = x * x + z * z;
            if (squared >= least * least || other == row ||
                (kHasLevels && std::fabs(self.y - agents.y[other]) > kLevelMetres)) {
                continue;
            }
            isClose = true;
            const float share = agents.preferredSpeed[other] > 0.0F ? 0.5F : 1.0F;
            const float distance = std::sqrt(squared);
            if (distance > 1e-4F) {
                wayX += share * x * (least - distance) / distance;
                wayZ += share * z * (least - distance) / distance;
            } else {
                // On the same spot: apart along a line that both agree on.
                wayX += agents.agent[row] < agents.agent[other] ? share * least : -share * least;
            }
        }
    }
    return isClose;
}

template<bool kHasLevels>
[[gnu::always_inline]] inline std::size_t separate(const ForceJob& job, std::size_t begin,
                                                   std::size_t end)
{
    std::size_t moved = 0;
    for (std::size_t row = begin; row < end; ++row) {
        job.x[row] = job.agents.x[row];
        job.z[row] = job.agents.z[row];
        if (job.isCrowded[row] == 0 || job.agents.preferredSpeed[row] <= 0.0F) {
            continue;
        }
        BinLattice::Span spans[3];
        job.lattice.neighbourhood(job.lattice.binOfRow(row), spans);
        const Body self = bodyOf(job.agents, row);
        float wayX = 0.0F;
        float wayZ = 0.0F;
        if (!wayOut<kHasLevels>(job, row, self, spans, wayX, wayZ)) {
            continue;
        }
        ++moved;
        float x = self.x + wayX;
        float z = self.z + wayZ;
        keepOutOfWalls(job, self, x, z);
        job.x[row] = x;
        job.z[row] = z;
    }
    return moved;
}

} // namespace

CROWD_CLONES void advanceRows(const ForceJob& job, std::size_t begin, std::size_t end)
{
    if (job.hasLevels) {
        advance<true>(job, begin, end);
    } else {
        advance<false>(job, begin, end);
    }
}

CROWD_CLONES std::size_t separateRows(const ForceJob& job, std::size_t begin, std::size_t end)
{
    return job.hasLevels ? separate<true>(job, begin, end) : separate<false>(job, begin, end);
}

} // namespace crowd::behavior
