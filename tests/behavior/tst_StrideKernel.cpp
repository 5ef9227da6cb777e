// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <numbers>

#include <QtTest/QTest>

#include "behavior/motion/StrideKernel.h"
#include "model/base/Random.h"
#include "tests/behavior/Actors.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::behavior;

/// Many people at once: the same on every processor, and the same as one by one.
class StrideKernelTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sameBitsOnAnyProcessor();
    void turnsToWhereTheyGo();
    void fullUpdateIsTheSame();
};

namespace {

constexpr std::size_t kPeople = 500; // no multiple of the lanes
constexpr float kStrideStep = 1.0F / 30.0F;

float anyBetween(float low, float high, std::uint64_t key, std::uint64_t agent)
{
    return low + (high - low) * model::unitFloat(model::hashKeys(key, agent));
}

std::vector<Body> someBodies()
{
    std::vector<Body> bodies(kPeople);
    for (std::size_t i = 0; i < kPeople; ++i) {
        bodies[i] = {.x = anyBetween(-9.0F, 9.0F, 1, i),
                     .z = anyBetween(-9.0F, 9.0F, 2, i),
                     .velocityX = anyBetween(-2.0F, 2.0F, 3, i),
                     .velocityZ = anyBetween(-2.0F, 2.0F, 4, i),
                     .preferredSpeed = anyBetween(-0.5F, 2.0F, 5, i)};
    }
    return bodies;
}

MotionState someMotion(const std::vector<Body>& bodies)
{
    MotionState motion;
    motion.assign(kPeople);
    for (std::size_t i = 0; i < kPeople; ++i) {
        motion.put(i, {bodies[i].x - 0.03F, 0.0F, bodies[i].z - 0.01F});
        motion.mode[i] = static_cast<std::int32_t>(i % 3);
        motion.heading[i] = anyBetween(-3.1F, 3.1F, 6, i);
        motion.speed[i] = anyBetween(0.0F, 2.0F, 7, i);
        motion.gaitPlace[i] = anyBetween(0.0F, 1.0F, 8, i);
        motion.perMetre[i] = i % 4 == 0 ? 0.0F : 0.7F;
        motion.perSecond[i] = 0.9F;
        motion.slowest[i] = 0.3F;
        motion.fastest[i] = 1.6F;
        motion.isGaitShown[i] = i % 5 == 0 ? 0 : -1;
    }
    return motion;
}

StrideParameters parameters()
{
    return {kStrideStep, 0.15F, 4.0F * kStrideStep, 0.15F, 0.02F, 12.0F};
}

} // namespace

void StrideKernelTest::sameBitsOnAnyProcessor()
{
    const std::vector<Body> bodies = someBodies();
    const std::vector<float> heights(kPeople + kLanes, 0.5F);
    std::array<MotionState, 2> motion;
    std::array<std::vector<Body>, 2> steered{bodies, bodies};
    std::array<std::vector<std::uint32_t>, 4> updates;
    Aims aims;
    aims.x.assign(kPeople + kLanes, 1.0F);
    aims.z.assign(kPeople + kLanes, -2.0F);
    aims.pace.assign(kPeople + kLanes, 1.3F);
    aims.mode.assign(kPeople + kLanes, static_cast<std::int32_t>(UpdateMode::Continue));
    model::Place kerb;
    kerb.position = {2.0F, 0.0F, 2.0F};
    kerb.shape = model::PlaceShape::Line;
    kerb.corners = {{-4.0F, 0.0F, 0.0F}, {4.0F, 0.0F, 3.0F}};
    const SlowArea slow[] = {
        {{2.0F, 2.0F}, 6.0F, 0.3F, kerb}, {{0.0F, 0.0F}, 3.0F, 0.5F}, {{1.0F, 0.0F}, 5.0F, 0.7F}};
    for (std::size_t kind = 0; kind < 2; ++kind) {
        StrideParameters p = parameters();
        p.hasPlainInstructions = kind == 1;
        motion[kind] = someMotion(bodies);
        updates[kind].resize(kStrideBlock + kLanes);
        updates[kind].resize(strideOn(bodies, std::span(heights).first(kPeople), motion[kind], p, 0,
                                      kPeople, updates[kind].data()));
        updates[kind + 2].resize(kStrideBlock + kLanes);
        updates[kind + 2].resize(steerStraightOn(steered[kind], aims, slow, 0, kPeople,
                                                 updates[kind + 2].data(), kind == 1));
    }
    QVERIFY(!updates[0].empty() && updates[0].size() < kPeople);
    QVERIFY(!updates[2].empty() && updates[2].size() < kPeople);
    QCOMPARE(updates[0], updates[1]);
    QCOMPARE(updates[2], updates[3]);
    for (std::size_t i = 0; i < kPeople; ++i) {
        for (const auto column :
             {&MotionState::x, &MotionState::heading, &MotionState::speed, &MotionState::stride,
              &MotionState::gaitPlace, &MotionState::rate}) {
            QVERIFY((motion[0].*column)[i] == (motion[1].*column)[i]);
        }
        QVERIFY(steered[0][i].desiredX == steered[1][i].desiredX);
        QVERIFY(steered[0][i].desiredZ == steered[1][i].desiredZ);
        QVERIFY(steered[0][i].preferredSpeed == steered[1][i].preferredSpeed);
    }
}

/// Against the library's functions.
void StrideKernelTest::turnsToWhereTheyGo()
{
    const std::vector<Body> bodies = someBodies();
    const std::vector<float> heights(kPeople + kLanes, 0.0F);
    MotionState motion = someMotion(bodies);
    std::ranges::fill(motion.mode, static_cast<std::int32_t>(UpdateMode::Continue));
    std::ranges::fill(motion.perMetre, 0.0F);
    std::ranges::fill(motion.slowest, -1.0F);
    std::ranges::fill(motion.fastest, 1e9F);
    StrideParameters p = parameters();
    p.mostTurn = 7.0F; // at once
    std::array<std::uint32_t, kStrideBlock + kLanes> updates;
    const MotionState before = motion;
    QCOMPARE(
        strideOn(bodies, std::span(heights).first(kPeople), motion, p, 0, kPeople, updates.data()),
        std::size_t{0});
    for (std::size_t i = 0; i < kPeople; ++i) {
        const float heading = std::atan2(bodies[i].velocityX, bodies[i].velocityZ);
        const bool turns = std::hypot(bodies[i].velocityX, bodies[i].velocityZ) > p.turnsAbove;
        const float expected = turns ? heading : before.heading[i];
        constexpr float kRound = 2.0F * std::numbers::pi_v<float>;
        QVERIFY(std::fabs(std::remainder(motion.heading[i] - expected, kRound)) < 1e-5F);
        const float ahead = (0.03F * std::sin(expected) + 0.01F * std::cos(expected)) / kStrideStep;
        QVERIFY(std::fabs(motion.stride[i] - std::max(ahead, 0.0F)) < 1e-4F);
    }
}

/// An edit in every step makes the session update every agent in full.
void StrideKernelTest::fullUpdateIsTheSame()
{
    model::Scene scene = testing::rowOf(40);
    scene.places = {{1, "a", {0.0F, 0.0F, 8.0F}, 2.0F}, {2, "b", {70.0F, 0.0F, 8.0F}, 2.0F}};
    scene.paths = {{1, "round", model::PathKind::Cyclic, {1, 2}}};
    const std::vector<std::uint32_t> paths(40, 1);
    scene.population.setValues<std::uint32_t>(model::columns::path, scene.population.ids(), paths);
    Session swift(scene);
    Session thorough(scene);
    for (int step = 0; step < 600; ++step) {
        swift.step();
        thorough.adopt(scene);
        thorough.step();
    }
    namespace keys = model::columns;
    const model::CrowdFramePtr a = swift.frame();
    const model::CrowdFramePtr b = thorough.frame();
    for (std::size_t row = 0; row < 40; ++row) {
        QVERIFY(a->population.column(keys::position)[row] ==
                b->population.column(keys::position)[row]);
        QCOMPARE(a->population.column(keys::clip)[row], b->population.column(keys::clip)[row]);
        const float turn =
            a->population.column(keys::heading)[row] - b->population.column(keys::heading)[row];
        QVERIFY(std::fabs(std::remainder(turn, 6.2831853F)) < 1e-3F);
        const float phase =
            a->population.column(keys::phase)[row] - b->population.column(keys::phase)[row];
        QVERIFY(std::fabs(std::remainder(phase, 1.0F)) < 1e-2F);
    }
}

CROWD_TEST(StrideKernelTest)
#include "tst_StrideKernel.moc"
