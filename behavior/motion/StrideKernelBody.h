// SPDX-License-Identifier: MIT
// What StrideKernel.h declares, included by StrideKernel.cpp once for each instruction set: see
// ForceKernelBody.h.

#include "behavior/crowd/KernelLanes.h"

CROWD_INLINE I8 loadWhole(const std::int32_t* from)
{
    return *reinterpret_cast<const I8InMemory*>(from);
}

CROWD_INLINE unsigned bitsOf(I8 mask)
{
    return bitsWhereLess(mask ? all(-1.0F) : all(0.0F), all(0.0F));
}

CROWD_INLINE void storeWhere(I8 mask, float* to, F8 value)
{
    store(to, mask ? value : load(to));
}

/// The largest whole number that is not above it.
CROWD_INLINE F8 wholeBelow(F8 value)
{
    const F8 towardsZero = __builtin_convertvector(__builtin_convertvector(value, I8), F8);
    return towardsZero - (towardsZero > value ? all(1.0F) : all(0.0F));
}

CROWD_INLINE F8 absolute(F8 value)
{
    return greater(value, -value);
}

/// As wrappedRadians().
CROWD_INLINE F8 wrapped(F8 angle)
{
    return angle - kTurn * wholeBelow(angle * (1.0F / kTurn) + 0.5F);
}

/// Angle of a way from +Z towards +X, within 2e-6; 0 for none.
CROWD_INLINE F8 angleOf(F8 x, F8 z)
{
    const F8 along = absolute(z);
    const F8 across = absolute(x);
    const F8 longer = greater(greater(along, across), all(1e-20F));
    const F8 t = lesser(along, across) / longer;
    const F8 s = t * t;
    // Minimax polynomial of the arc tangent on 0..1.
    const F8 arc =
        t * (0.99997726F +
             s * (-0.33262347F +
                  s * (0.19354346F + s * (-0.11643287F + s * (0.05265332F + s * -0.01172120F)))));
    const F8 quarter = across > along ? kTurn * 0.25F - arc : arc;
    const F8 half = z < 0.0F ? kTurn * 0.5F - quarter : quarter;
    return x < 0.0F ? -half : half;
}

/// Sine of an angle within half a turn of 0, within 1e-6.
CROWD_INLINE F8 sineOf(F8 angle)
{
    // Beyond a quarter of a turn it comes back.
    const F8 size = absolute(angle);
    const F8 folded = lesser(size, kTurn * 0.5F - size);
    const F8 s = folded * folded;
    const F8 sine =
        folded *
        (0.99999999F +
         s * (-0.16666660F + s * (0.0083330603F + s * (-0.00019810703F + s * 2.6030103e-06F))));
    return angle < 0.0F ? -sine : sine;
}

/// A block of bodies; those beyond the end are the last one once more.
CROWD_INLINE void bodiesOf(std::span<const Body> bodies, std::size_t first, F8 (&body)[kLanes])
{
    const float* records[kLanes];
    if (first + kLanes <= bodies.size()) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            records[i] = &bodies[first].x + i * kLanes;
        }
    } else {
        for (std::size_t i = 0; i < kLanes; ++i) {
            records[i] = &bodies[std::min(first + i, bodies.size() - 1)].x;
        }
    }
    transpose(records, body);
}

inline std::size_t steer(std::span<Body> bodies, const Aims& aims, std::span<const SlowArea> slow,
                         std::size_t begin, std::size_t end, std::uint32_t* needUpdate)
{
    std::size_t updates = 0;
    for (std::size_t first = begin; first < end; first += kLanes) {
        F8 body[kLanes]; // in the order of Body
        bodiesOf(bodies, first, body);
        const F8 pace = load(aims.pace.data() + first);
        const F8 wayX = load(aims.x.data() + first) - body[0];
        const F8 wayZ = load(aims.z.data() + first) - body[1];
        const F8 squared = squaredDistances(wayX, wayZ);
        const I8 isPast = wayX * body[2] + wayZ * body[3] < 0.0F;
        const F8 braking = squaredDistances(body[2], body[3]) / (2.0F * kUsualBraking);
        const F8 near = greater(isPast ? all(kPassedMetres) : all(kArrivalMetres), braking);
        const I8 mode = loadWhole(aims.mode.data() + first);
        const I8 needsUpdate =
            (mode == static_cast<std::int32_t>(UpdateMode::Full)) |
            ((mode == static_cast<std::int32_t>(UpdateMode::Continue)) & (squared < near * near));
        F8 share = all(1.0F);
        for (std::size_t i = slow.size(); i-- > 0;) { // the first one that they are in
            const F8 away =
                squaredDistances(body[0] - slow[i].center.x, body[1] - slow[i].center.y);
            I8 isIn = away < slow[i].radius * slow[i].radius;
            for (std::size_t l = 0; slow[i].shape && l < kLanes; ++l) {
                isIn[l] = isIn[l] != 0 && isInShape(slow[i], body[0][l], body[1][l]) ? -1 : 0;
            }
            share = isIn ? all(slow[i].share) : share;
        }
        const F8 speed = pace * share;
        const F8 length = squareRoot(greater(squared, all(1e-8F)));
        const F8 wishX = wayX / length * speed;
        const F8 wishZ = wayZ / length * speed;
        const std::size_t lanes = std::min(kLanes, end - first);
        const unsigned bits = bitsOf(needsUpdate) & ((1U << lanes) - 1U);
        for (std::size_t i = 0; i < lanes; ++i) {
            Body& to = bodies[first + i];
            to.desiredX = wishX[i];
            to.desiredZ = wishZ[i];
            to.preferredSpeed = speed[i];
        }
        listBits(bits, static_cast<std::uint32_t>(first), needUpdate + updates);
        updates += static_cast<std::size_t>(std::popcount(bits));
    }
    return updates;
}

/// Speeds, and headings after turning to where people go as far as they can in a step. A loop of
/// its own, as in ForceKernelBody.h.
CROWD_INLINE void turnAll(std::span<const Body> bodies, const MotionState& b,
                          const StrideParameters& p, std::size_t begin, std::size_t end,
                          Turned& turned)
{
    for (std::size_t first = begin; first < end; first += kLanes) {
        F8 body[kLanes]; // in the order of Body
        bodiesOf(bodies, first, body);
        const F8 speed = squareRoot(squaredDistances(body[2], body[3]));
        const F8 before = load(b.heading.data() + first);
        const F8 turn = wrapped(angleOf(body[2], body[3]) - before);
        const F8 after = wrapped(before + greater(lesser(turn, all(p.mostTurn)), all(-p.mostTurn)));
        const std::size_t i = first - begin;
        store(turned.x + i, body[0]);
        store(turned.z + i, body[1]);
        store(turned.speed + i, speed);
        store(turned.preferred + i, body[6]);
        store(turned.heading + i, speed > p.turnsAbove ? after : before);
    }
}

/// Who of a block goes on as before, and who is to be looked at again; their eased speeds.
struct Gait
{
    I8 isWalk;
    I8 needsUpdate;
    I8 goesOn;
    F8 smooth; ///< metres per second
};

CROWD_INLINE Gait gaitOf(const Turned& turned, const MotionState& b, const StrideParameters& p,
                         std::size_t first, std::size_t i)
{
    const I8 mode = loadWhole(b.mode.data() + first);
    const I8 mayGoOn = mode == static_cast<std::int32_t>(UpdateMode::Continue);
    const F8 speed = load(turned.speed + i);
    const I8 wantsOn = load(turned.preferred + i) > 0.0F;
    const I8 isWalk = load(b.perMetre.data() + first) > 0.0F;
    const F8 former = load(b.speed.data() + first);
    const F8 smooth = former + (speed - former) * p.smoothing;
    const F8 paced = wantsOn ? (isWalk ? smooth : greater(speed, smooth)) : speed;
    const I8 isBeyond = (paced > load(b.fastest.data() + first)) |
                        (paced < load(b.slowest.data() + first)) | (isWalk & ~wantsOn);
    const I8 needsUpdate = (mode == static_cast<std::int32_t>(UpdateMode::Full)) |
                           (mayGoOn & isBeyond) |
                           ((mode == static_cast<std::int32_t>(UpdateMode::Rest)) &
                            ((speed > p.movesAbove) | wantsOn));
    return {isWalk, needsUpdate, mayGoOn & ~needsUpdate, smooth};
}

/// Moves those of a block that go on to where they are now, and their gait along with the way.
CROWD_INLINE void goOn(const Turned& turned, std::span<const float> heights, MotionState& b,
                       const StrideParameters& p, std::size_t first, std::size_t i,
                       const Gait& gait)
{
    const F8 x = load(turned.x + i);
    const F8 z = load(turned.z + i);
    const F8 heading = load(turned.heading + i);
    const F8 wayX = x - load(b.x.data() + first);
    const F8 wayZ = z - load(b.z.data() + first);
    const F8 quarter = wrapped(heading + kTurn * 0.25F);
    const F8 ahead = (wayX * sineOf(heading) + wayZ * sineOf(quarter)) * (1.0F / p.stepSeconds);
    const F8 stride = ahead < p.fastest ? greater(ahead, all(0.0F)) : all(0.0F);
    const F8 perSecond = load(b.perSecond.data() + first);
    const F8 rest = perSecond > 0.0F ? all(1.0F) : F8{};
    const F8 rate = gait.isWalk ? stride * load(b.perMetre.data() + first) : rest;
    F8 place = load(b.gaitPlace.data() + first) + rate * p.stepSeconds * perSecond;
    place -= wholeBelow(place);

    storeWhere(gait.goesOn, b.x.data() + first, x);
    storeWhere(gait.goesOn, b.y.data() + first, load(heights.data() + first));
    storeWhere(gait.goesOn, b.z.data() + first, z);
    storeWhere(gait.goesOn, b.heading.data() + first, heading);
    storeWhere(gait.goesOn, b.speed.data() + first, gait.smooth);
    storeWhere(gait.goesOn, b.stride.data() + first, stride);
    storeWhere(gait.goesOn, b.gaitPlace.data() + first, place);
    const I8 isShown = gait.goesOn & loadWhole(b.isGaitShown.data() + first);
    storeWhere(isShown, b.place.data() + first, place);
    storeWhere(isShown, b.rate.data() + first, rate);
}

inline std::size_t stride(std::span<const Body> bodies, std::span<const float> heights,
                          MotionState& b, const StrideParameters& p, std::size_t begin,
                          std::size_t end, std::uint32_t* needUpdate)
{
    Turned turned;
    turnAll(bodies, b, p, begin, end, turned);
    std::size_t updates = 0;
    for (std::size_t first = begin; first < end; first += kLanes) {
        const Gait gait = gaitOf(turned, b, p, first, first - begin);
        goOn(turned, heights, b, p, first, first - begin, gait);
        const std::size_t lanes = std::min(kLanes, end - first);
        const unsigned bits = bitsOf(gait.needsUpdate) & ((1U << lanes) - 1U);
        listBits(bits, static_cast<std::uint32_t>(first), needUpdate + updates);
        updates += static_cast<std::size_t>(std::popcount(bits));
    }
    return updates;
}

#undef CROWD_INLINE
