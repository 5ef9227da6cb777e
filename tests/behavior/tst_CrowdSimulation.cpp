// SPDX-License-Identifier: MIT
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include <QtTest/QTest>

#include <glm/geometric.hpp>

#include "behavior/workload/Workload.h"
#include "behavior/workload/WorkloadRun.h"
#include "model/base/Parallel.h"
#include "model/base/Random.h"
#include "tests/program/Test.h"

using namespace crowd;
using behavior::AgentState;
using behavior::CrowdSimulation;
using behavior::Wall;

/// Bodies that avoid each other: the same on any number of threads, and as they should be.
class CrowdSimulationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sameBitsForAnyNumberOfThreads_data();
    void sameBitsForAnyNumberOfThreads();
    void sameBitsOnAnyProcessor();
    void doesNotDependOnThePast();
    void figures_data();
    void figures();
    void longJamStaysWhole();
    void standingPeopleAreNotMoved();
    void nobodyPassesAWall_data();
    void nobodyPassesAWall();
    void aWallOfPiecesPressesLikeOne();
    void otherLevelsDoNotMatter();
    void peopleOnOneSpotComeApartCalmly();
    void survivesNonsense();
};

namespace {

/// All there is to know of a crowd.
std::vector<std::uint32_t> bitsOf(const CrowdSimulation& crowd)
{
    std::vector<std::uint32_t> bits;
    for (const behavior::Body& body : crowd.bodies()) {
        for (const float value : {body.x, body.z, body.velocityX, body.velocityZ}) {
            bits.push_back(std::bit_cast<std::uint32_t>(value));
        }
    }
    return bits;
}

void steerAll(CrowdSimulation& crowd, const glm::vec2& velocity)
{
    for (behavior::Body& body : crowd.bodies()) {
        body.desiredX = velocity.x;
        body.desiredZ = velocity.y;
    }
}

std::vector<AgentState> statesOf(const CrowdSimulation& crowd)
{
    std::vector<AgentState> states;
    for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
        const behavior::Body& body = crowd.bodies()[agent];
        states.push_back({{body.x, body.z},
                          {body.velocityX, body.velocityZ},
                          crowd.heights()[agent],
                          body.radius,
                          body.preferredSpeed});
    }
    return states;
}

} // namespace

void CrowdSimulationTest::sameBitsForAnyNumberOfThreads_data()
{
    QTest::addColumn<QString>("workload");
    QTest::addColumn<int>("count");
    QTest::newRow("square") << QStringLiteral("square") << 6000;
    QTest::newRow("corridor") << QStringLiteral("corridor") << 5000;
    QTest::newRow("city") << QStringLiteral("city") << 4000;
}

void CrowdSimulationTest::sameBitsForAnyNumberOfThreads()
{
    QFETCH(const QString, workload);
    QFETCH(const int, count);
    std::vector<std::uint32_t> expected;
    for (const int threads : {1, 2, 5}) {
        const model::ThreadLimit limit(threads);
        auto made =
            behavior::makeWorkload(workload.toStdString(), static_cast<std::size_t>(count), 3);
        QVERIFY(made.isOk());
        (void)behavior::runWorkload(*made.value(), 60, nullptr);
        const std::vector<std::uint32_t> bits = bitsOf(made.value()->crowd());
        if (expected.empty()) {
            expected = bits;
        }
        QVERIFY(bits == expected);
    }
}

/// The kernel for new processors against the one for all of them, with all that it can reckon with.
void CrowdSimulationTest::sameBitsOnAnyProcessor()
{
    std::vector<std::uint32_t> expected;
    for (const bool isPlain : {false, true}) {
        auto made = behavior::makeWorkload("corridor", 1001, 3);
        QVERIFY(made.isOk());
        CrowdSimulation& crowd = made.value()->crowd();
        crowd.parameters.plainInstructions = isPlain;
        crowd.setLevels(true);
        for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
            crowd.heights()[agent] = agent % 10 == 0 ? 3.0F : 0.0F;
            crowd.bodies()[agent].preferredSpeed =
                agent % 50 == 1 ? 0.0F : behavior::kWorkloadSpeed;
        }
        (void)behavior::runWorkload(*made.value(), 200, nullptr);
        const std::vector<std::uint32_t> bits = bitsOf(crowd);
        if (expected.empty()) {
            expected = bits;
        }
        QVERIFY(bits == expected);
    }
}

/// Who is put down where another crowd has got to goes on just like it.
void CrowdSimulationTest::doesNotDependOnThePast()
{
    auto made = behavior::makeWorkload("corridor", 400, 3);
    QVERIFY(made.isOk());
    CrowdSimulation& crowd = made.value()->crowd();
    (void)behavior::runWorkload(*made.value(), 50, nullptr);
    CrowdSimulation fresh;
    fresh.setWalls(behavior::rectangleWalls({0.0F, 0.0F}, {20.0F, 10.0F}));
    fresh.setAgents(statesOf(crowd));
    for (int i = 0; i < 20; ++i) {
        steerAll(crowd, {1.0F, 0.2F});
        steerAll(fresh, {1.0F, 0.2F});
        crowd.step(behavior::kWorkloadStep);
        fresh.step(behavior::kWorkloadStep);
    }
    QVERIFY(bitsOf(crowd) == bitsOf(fresh));
}

void CrowdSimulationTest::figures_data()
{
    QTest::addColumn<QString>("workload");
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("leastEfficiency");
    QTest::addColumn<double>("mostAcceleration");
    QTest::newRow("square") << QStringLiteral("square") << 10000 << 0.88 << 0.6;
    QTest::newRow("corridor") << QStringLiteral("corridor") << 2000 << 0.55 << 1.0;
}

void CrowdSimulationTest::figures()
{
    QFETCH(const QString, workload);
    QFETCH(const int, count);
    QFETCH(const double, leastEfficiency);
    QFETCH(const double, mostAcceleration);
    auto made = behavior::makeWorkload(workload.toStdString(), static_cast<std::size_t>(count), 1);
    QVERIFY(made.isOk());
    const behavior::WorkloadFigures figures = behavior::runWorkload(*made.value(), 300, nullptr);
    QCOMPARE(figures.overlapsPer1000, 0.0);
    QCOMPARE(figures.outsideWalls, 0.0);
    QCOMPARE(figures.brokenNumbers, std::size_t{0});
    QVERIFY2(figures.efficiency >= leastEfficiency, QByteArray::number(figures.efficiency));
    QVERIFY2(figures.rmsAcceleration <= mostAcceleration,
             QByteArray::number(figures.rmsAcceleration));
    QVERIFY2(figures.bytesPerAgent <= 150.0, QByteArray::number(figures.bytesPerAgent));
}

/// 100 seconds of the dense corridor in two directions.
void CrowdSimulationTest::longJamStaysWhole()
{
    auto made = behavior::makeWorkload("corridor", 2000, 2);
    QVERIFY(made.isOk());
    const behavior::WorkloadFigures figures = behavior::runWorkload(*made.value(), 3000, nullptr);
    QVERIFY2(figures.overlapsPer1000 <= 0.5, QByteArray::number(figures.overlapsPer1000));
    QCOMPARE(figures.outsideWalls, 0.0);
    QCOMPARE(figures.brokenNumbers, std::size_t{0});
}

void CrowdSimulationTest::standingPeopleAreNotMoved()
{
    std::vector<AgentState> states(41);
    for (std::size_t i = 0; i < 40; ++i) {
        states[i].position = {-3.0F - static_cast<float>(i / 4) * 0.6F,
                              (static_cast<float>(i % 4) - 1.5F) * 0.6F};
    }
    states[40].preferredSpeed = 0.0F;
    CrowdSimulation crowd;
    crowd.setAgents(states);
    for (int i = 0; i < 600; ++i) {
        steerAll(crowd, {1.3F, 0.0F});
        crowd.step(behavior::kWorkloadStep);
        QCOMPARE(crowd.bodies()[40].x, 0.0F);
        QCOMPARE(crowd.bodies()[40].z, 0.0F);
        QCOMPARE(behavior::countPairsCloserThan(crowd, 0.4F), std::size_t{0});
    }
    for (const behavior::Body& body : crowd.bodies().first(40)) {
        QVERIFY(body.x > 0.5F); // all went around
    }
}

void CrowdSimulationTest::nobodyPassesAWall_data()
{
    QTest::addColumn<float>("angle");
    QTest::addColumn<int>("pieces");
    QTest::newRow("straight on, in one piece") << 0.0F << 1;
    QTest::newRow("straight on, in many pieces") << 0.0F << 50;
    QTest::newRow("slanting") << 0.7F << 7;
    QTest::newRow("nearly along it") << 1.5F << 3;
}

/// A crowd presses against a wall that is turned by an angle and a little longer than the crowd.
void CrowdSimulationTest::nobodyPassesAWall()
{
    QFETCH(const float, angle);
    QFETCH(const int, pieces);
    const glm::vec2 across(std::cos(angle), std::sin(angle));
    const glm::vec2 along(-across.y, across.x);
    std::vector<Wall> walls;
    for (int i = 0; i < pieces; ++i) {
        const auto at = [&](int end) {
            return along * (-60.0F + 120.0F * static_cast<float>(end) / static_cast<float>(pieces));
        };
        walls.push_back({at(i), at(i + 1)});
    }
    std::vector<AgentState> states(200);
    for (std::size_t i = 0; i < states.size(); ++i) {
        states[i].position = across * (-0.6F - 0.55F * static_cast<float>(i / 20)) +
                             along * (0.55F * static_cast<float>(i % 20) - 5.0F);
    }
    CrowdSimulation crowd;
    crowd.setWalls(walls);
    crowd.setAgents(states);
    for (int i = 0; i < 600; ++i) {
        steerAll(crowd, {2.0F, 0.0F});
        crowd.step(behavior::kWorkloadStep);
        for (const behavior::Body& body : crowd.bodies()) {
            QVERIFY(glm::dot(glm::vec2(body.x, body.z), across) < 0.0F);
        }
    }
}

void CrowdSimulationTest::aWallOfPiecesPressesLikeOne()
{
    const auto wayBeside = [](int pieces) {
        std::vector<Wall> walls;
        for (int i = 0; i < pieces; ++i) {
            const float length = 40.0F / static_cast<float>(pieces);
            walls.push_back({{-20.0F + length * static_cast<float>(i), 0.0F},
                             {-20.0F + length * static_cast<float>(i + 1), 0.0F}});
        }
        CrowdSimulation crowd;
        crowd.setWalls(walls);
        const AgentState walker{{-10.0F, 0.5F}, {1.3F, 0.0F}};
        crowd.setAgents({&walker, 1});
        for (int i = 0; i < 200; ++i) {
            steerAll(crowd, {1.3F, -0.5F});
            crowd.step(behavior::kWorkloadStep);
        }
        return glm::vec2(crowd.bodies()[0].x, crowd.bodies()[0].z);
    };
    QVERIFY(glm::distance(wayBeside(1), wayBeside(37)) < 0.01F);
    QVERIFY(wayBeside(1).y > 0.2F);
}

void CrowdSimulationTest::otherLevelsDoNotMatter()
{
    const AgentState states[] = {{{-2.0F, 0.0F}, {1.3F, 0.0F}, 0.0F},
                                 {{2.0F, 0.05F}, {-1.3F, 0.0F}, 5.0F}};
    CrowdSimulation crowd;
    crowd.setAgents(states);
    crowd.setLevels(true);
    for (int i = 0; i < 90; ++i) {
        crowd.bodies()[0].desiredX = 1.3F;
        crowd.bodies()[1].desiredX = -1.3F;
        crowd.step(behavior::kWorkloadStep);
    }
    QCOMPARE(crowd.bodies()[0].z, 0.0F); // never gave way
    QCOMPARE(crowd.bodies()[1].z, 0.05F);
}

void CrowdSimulationTest::peopleOnOneSpotComeApartCalmly()
{
    constexpr std::size_t kPeople = 1500;
    CrowdSimulation crowd;
    crowd.setAgents(std::vector<AgentState>(kPeople));
    std::vector<behavior::Body> before;
    for (int step = 0; step < 180; ++step) {
        before.assign(crowd.bodies().begin(), crowd.bodies().end());
        crowd.step(behavior::kWorkloadStep);
        for (std::size_t agent = 0; agent < kPeople; ++agent) {
            const float moved =
                glm::distance(glm::vec2(crowd.bodies()[agent].x, crowd.bodies()[agent].z),
                              glm::vec2(before[agent].x, before[agent].z));
            QVERIFY2(moved < 0.5F, QByteArray::number(static_cast<double>(moved)));
        }
    }
    // As many as stand shoulder to shoulder, on all sides.
    float farthest = 0.0F;
    glm::vec2 low(0.0F);
    glm::vec2 high(0.0F);
    for (const behavior::Body& body : crowd.bodies()) {
        const glm::vec2 at(body.x, body.z);
        farthest = std::max(farthest, glm::length(at));
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    QVERIFY2(farthest < 20.0F, QByteArray::number(static_cast<double>(farthest)));
    QVERIFY(std::min({-low.x, -low.y, high.x, high.y}) > 4.0F);
    QVERIFY(behavior::countPairsCloserThan(crowd, 0.35F) < kPeople / 100);
}

void CrowdSimulationTest::survivesNonsense()
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    std::vector<AgentState> states(3000); // all on one spot
    states[0] = {{nan, infinity}, {nan, -infinity}, nan, nan, nan};
    states[1] = {{1e30F, -1e30F}, {1e30F, 0.0F}, 0.0F, 1e30F, 1e30F};
    const Wall walls[] = {{{nan, 0.0F}, {1.0F, 1.0F}},
                          {{1.0F, 1.0F}, {1.0F, 1.0F}},
                          {{-1e30F, 0.0F}, {1e30F, 0.0F}},
                          {{-5.0F, -5.0F}, {5.0F, -5.0F}}};
    CrowdSimulation crowd;
    crowd.setWalls(walls);
    crowd.setAgents(states);
    for (const float seconds :
         {0.0F, nan, -1.0F, infinity, behavior::kWorkloadStep, behavior::kWorkloadStep}) {
        steerAll(crowd, {nan, 1.0F});
        crowd.step(seconds);
    }
    for (const behavior::Body& body : crowd.bodies()) {
        QVERIFY(std::isfinite(body.x) && std::isfinite(body.z));
        QVERIFY(std::isfinite(body.velocityX) && std::isfinite(body.velocityZ));
    }
}

CROWD_TEST(CrowdSimulationTest)
#include "tst_CrowdSimulation.moc"
