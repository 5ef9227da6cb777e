// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <QtTest/QTest>

#include <glm/geometric.hpp>

#include "behavior/crowd/CrowdSimulation.h"
#include "behavior/session/Session.h"
#include "behavior/workload/Workload.h"
#include "model/base/Parallel.h"
#include "model/project/SceneAssets.h"
#include "tests/behavior/Actors.h"
#include "tests/behavior/BoxStage.h"
#include "tests/program/Test.h"

using namespace crowd;
using behavior::AgentState;
using behavior::Body;
using behavior::CrowdSimulation;
using behavior::LongBody;
using behavior::Session;
using behavior::Wall;

/// Bodies that are wider than a person, or longer than they are wide, take the room that they need.
class LongBodiesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void wideBodiesKeepFurtherAway();
    void nobodyWalksThroughALongBody_data();
    void nobodyWalksThroughALongBody();
    void longBodiesKeepOutOfEachOther();
    void longBodiesKeepOutOfWalls();
    void sameBitsForAnyNumberOfThreads();
    void aHerdDoesNotOverlap();
    void walkersGoAroundWhatIsParked_data();
    void walkersGoAroundWhatIsParked();
    void detoursAreTheSameForAnyNumberOfThreads();
};

namespace {

/// From a point to the middle line of a long body.
float awayFrom(const glm::vec2& point, const Body& own, const LongBody& body)
{
    const glm::vec2 way(body.headingX, body.headingZ);
    const glm::vec2 from = point - glm::vec2(own.x, own.z);
    const float along = std::clamp(glm::dot(from, way), -body.back, body.front);
    return glm::length(from - along * way);
}

glm::vec2 flatPlaceOf(const Body& body)
{
    return {body.x, body.z};
}

/// Somebody 0.8 m wide and so long, beside the people of Actors.h.
model::TemplateEntry horseTemplate(float metres)
{
    model::TemplateEntry entry = testing::actorTemplate();
    auto asset = std::make_shared<model::Template>(*entry.asset);
    asset->footprint = {0.4F, 0.5F * metres - 0.4F, 0.5F * metres - 0.4F};
    entry.asset = asset;
    entry.id = 2;
    return entry;
}

void turnAsTheyGo(CrowdSimulation& crowd)
{
    for (LongBody& body : crowd.longBodies()) {
        const Body& own = crowd.bodies()[body.agent];
        const glm::vec2 velocity(own.velocityX, own.velocityZ);
        if (glm::length(velocity) > 0.15F) {
            const glm::vec2 way = glm::normalize(velocity);
            body.headingX = way.x;
            body.headingZ = way.y;
        }
    }
}

} // namespace

void LongBodiesTest::wideBodiesKeepFurtherAway()
{
    const auto nearest = [](float radius) {
        CrowdSimulation crowd;
        crowd.setAgents(std::vector<AgentState>{{.position = {0.0F, 0.0F}, .radius = 0.25F},
                                                {.position = {0.05F, 8.0F}, .radius = radius}});
        float least = 100.0F;
        for (int step = 0; step < 300; ++step) {
            crowd.bodies()[0].desiredZ = 1.3F;
            crowd.bodies()[1].desiredZ = -1.3F;
            crowd.step(behavior::kWorkloadStep);
            least = std::min(least, glm::distance(flatPlaceOf(crowd.bodies()[0]),
                                                  flatPlaceOf(crowd.bodies()[1])));
        }
        return least;
    };
    QVERIFY(nearest(0.25F) > 0.4F);
    QVERIFY2(nearest(1.0F) > 0.82F * 1.25F, qPrintable(QString::number(nearest(1.0F))));
    QVERIFY2(nearest(2.0F) > 0.82F * 2.25F, qPrintable(QString::number(nearest(2.0F))));
}

void LongBodiesTest::nobodyWalksThroughALongBody_data()
{
    QTest::addColumn<float>("speed");
    QTest::newRow("it stands across the way") << 0.0F;
    QTest::newRow("it crosses") << 1.0F;
}

void LongBodiesTest::nobodyWalksThroughALongBody()
{
    QFETCH(const float, speed);
    std::vector<AgentState> states{
        {.position = {0.0F, 6.0F}, .radius = 0.4F, .preferredSpeed = speed}};
    for (int i = 0; i < 30; ++i) {
        states.push_back(
            {.position = {static_cast<float>(i % 6) - 2.5F, -0.8F * static_cast<float>(i / 6)}});
    }
    CrowdSimulation crowd;
    crowd.setAgents(states, std::vector<LongBody>{{0, 1.2F, 1.2F, 1.0F, 0.0F}});
    float least = 100.0F;
    for (int step = 0; step < 450; ++step) {
        for (Body& body : crowd.bodies()) {
            body.desiredZ = 1.3F;
        }
        crowd.bodies()[0].desiredZ = 0.0F;
        crowd.bodies()[0].desiredX = speed;
        crowd.step(behavior::kWorkloadStep);
        const LongBody& horse = crowd.longBodies().front();
        for (const Body& body : crowd.bodies().subspan(1)) {
            least = std::min(least, awayFrom(flatPlaceOf(body), crowd.bodies()[0], horse));
        }
    }
    QVERIFY2(least > 0.7F * 0.65F, qPrintable(QString::number(least)));
    // They all get past what moves on; nobody looks for a way around what stands.
    QVERIFY(speed == 0.0F || std::ranges::all_of(crowd.bodies().subspan(1),
                                                 [](const Body& body) { return body.z > 6.5F; }));
}

void LongBodiesTest::longBodiesKeepOutOfEachOther()
{
    std::vector<AgentState> states;
    std::vector<LongBody> horses;
    for (int i = 0; i < 8; ++i) {
        const float side = i % 2 == 0 ? 1.0F : -1.0F;
        states.push_back(
            {.position = {-8.0F * side, 1.2F * static_cast<float>(i) - 4.0F}, .radius = 0.4F});
        horses.push_back({static_cast<std::uint32_t>(i), 0.9F, 0.9F, side, 0.0F});
    }
    CrowdSimulation crowd;
    crowd.setAgents(states, horses);
    float least = 100.0F;
    for (int step = 0; step < 600; ++step) {
        for (std::size_t i = 0; i < 8; ++i) {
            crowd.bodies()[i].desiredX = i % 2 == 0 ? 1.3F : -1.3F;
        }
        turnAsTheyGo(crowd);
        crowd.step(behavior::kWorkloadStep);
        for (const LongBody& horse : crowd.longBodies()) {
            for (std::size_t other = 0; other < 8 && step > 30; ++other) {
                if (other != horse.agent) {
                    least = std::min(least, awayFrom(flatPlaceOf(crowd.bodies()[other]),
                                                     crowd.bodies()[horse.agent], horse));
                }
            }
        }
    }
    QVERIFY2(least > 0.5F * 0.8F, qPrintable(QString::number(least)));
}

void LongBodiesTest::longBodiesKeepOutOfWalls()
{
    CrowdSimulation crowd;
    crowd.setAgents(std::vector<AgentState>{{.position = {0.0F, 0.0F}, .radius = 0.5F}},
                    std::vector<LongBody>{{0, 1.5F, 1.5F}});
    crowd.setWalls(std::vector<Wall>{{{-20.0F, 6.0F}, {20.0F, 6.0F}}});
    for (int step = 0; step < 400; ++step) {
        crowd.bodies()[0].desiredZ = 1.3F;
        crowd.step(behavior::kWorkloadStep); // it keeps facing the wall
        QVERIFY2(crowd.bodies()[0].z + 1.5F < 6.0F - 0.4F,
                 qPrintable(QString::number(crowd.bodies()[0].z)));
    }
    QVERIFY(crowd.bodies()[0].z > 2.5F); // it did come there
}

void LongBodiesTest::sameBitsForAnyNumberOfThreads()
{
    std::vector<AgentState> states;
    std::vector<LongBody> horses;
    for (std::uint32_t i = 0; i < 4000; ++i) {
        states.push_back({.position = {static_cast<float>(i % 80), static_cast<float>(i / 80)},
                          .radius = i % 7 == 0 ? 0.4F : 0.25F});
        if (i % 7 == 0) {
            horses.push_back({i, 0.8F, 0.8F, 0.0F, 1.0F});
        }
    }
    const auto run = [&](int threads) {
        const model::ThreadLimit limit(threads);
        CrowdSimulation crowd;
        crowd.setAgents(states, horses);
        for (int step = 0; step < 20; ++step) {
            for (Body& body : crowd.bodies()) {
                body.desiredX = body.x < 40.0F ? 1.3F : -1.3F;
            }
            turnAsTheyGo(crowd);
            crowd.step(behavior::kWorkloadStep);
        }
        std::vector<std::uint32_t> bits;
        for (const Body& body : crowd.bodies()) {
            for (const float value : {body.x, body.z, body.velocityX, body.velocityZ}) {
                bits.push_back(std::bit_cast<std::uint32_t>(value));
            }
        }
        return bits;
    };
    QCOMPARE(run(1), run(4));
}

/// Horses that walk to one place, as an artist lets them.
void LongBodiesTest::aHerdDoesNotOverlap()
{
    model::Scene scene;
    model::TemplateEntry entry;
    entry.id = 1;
    entry.path = "builtin:templates/horse.glb";
    const auto asset = model::loadTemplateAsset(entry);
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    model::attachAsset(entry, asset.value());
    scene.templates.push_back(entry);
    const model::Footprint body = asset.value()->footprint;
    QVERIFY2(
        body.radius > 0.2F && body.radius < 0.6F && body.front + body.back > 0.8F,
        qPrintable(QStringLiteral("%1 %2 %3").arg(body.radius).arg(body.front).arg(body.back)));
    scene.places = {{.id = 1, .name = "end", .position = {0.0F, 0.0F, 30.0F}, .radius = 4.0F}};
    scene.paths = {{.id = 1, .name = "way", .places = {1}}};
    constexpr std::size_t kHorses = 12;
    std::vector<model::IndividualId> ids;
    for (std::size_t i = 0; i < kHorses; ++i) {
        ids.push_back(static_cast<model::IndividualId>(i + 1));
    }
    auto rows = model::IndividualRows::withDefaults(ids);
    for (std::size_t i = 0; i < kHorses; ++i) {
        rows.column(model::columns::templateId)[i] = 1;
        rows.column(model::columns::path)[i] = 1;
        rows.column(model::columns::position)[i] = {4.0F * static_cast<float>(i % 4) - 6.0F, 0.0F,
                                                    -4.0F * static_cast<float>(i / 4)};
    }
    scene.population.add(rows);
    Session session(scene);
    float least = 100.0F;
    for (int step = 0; step < 1200; ++step) {
        session.step();
        for (const LongBody& horse : session.crowd().longBodies()) {
            const Body& own = session.crowd().bodies()[horse.agent];
            for (std::size_t other = 0; other < kHorses; ++other) {
                if (other != horse.agent) {
                    least = std::min(
                        least, awayFrom(flatPlaceOf(session.crowd().bodies()[other]), own, horse));
                }
            }
        }
    }
    QVERIFY2(least > body.radius, qPrintable(QString::number(least)));
    QVERIFY(session.pose()->z.front() > 20.0F);
}

void LongBodiesTest::walkersGoAroundWhatIsParked_data()
{
    QTest::addColumn<std::vector<glm::vec3>>("parked"); // x, heading, z
    QTest::addColumn<float>("wallTo");                  // a wall from there to x = 6
    constexpr float kAcross = 1.5707963F;
    const auto row = [](const char* name, std::vector<glm::vec3> parked, float wallTo = 6.0F) {
        QTest::newRow(name) << std::move(parked) << wallTo;
    };
    row("one across the way", {{0.0F, kAcross, 0.0F}});
    row("one along the way", {{0.0F, 0.0F, 0.0F}});
    row("one aslant", {{0.3F, 0.8F, 0.0F}});
    row("two between which nobody gets through", {{-1.7F, kAcross, 0.0F}, {1.7F, kAcross, 0.0F}});
    row("two with a gap", {{-2.4F, kAcross, 0.0F}, {2.4F, kAcross, 0.0F}});
    row("one behind the other", {{0.0F, kAcross, 0.0F}, {0.8F, kAcross, 3.0F}});
    row("one beside a wall", {{1.0F, kAcross, 0.0F}}, 2.2F);
}

/// Thirty people in a stream, and those who stand in the middle of it.
void LongBodiesTest::walkersGoAroundWhatIsParked()
{
    QFETCH(const std::vector<glm::vec3>, parked);
    QFETCH(const float, wallTo);
    constexpr std::size_t kPeople = 30;
    model::Scene scene;
    scene.templates = {testing::actorTemplate(), horseTemplate(3.0F)};
    if (wallTo < 6.0F) {
        model::StageMesh wall;
        testing::addBox(wall, {wallTo, 0.0F, -3.0F}, {6.0F, 3.0F, 3.0F});
        scene.stages = {testing::stageOf(wall)};
    }
    scene.places = {{.id = 1, .name = "end", .position = {0.0F, 0.0F, 14.0F}, .radius = 2.0F}};
    scene.paths = {{.id = 1, .name = "way", .places = {1}}};
    std::vector<model::IndividualId> ids(kPeople + parked.size());
    std::iota(ids.begin(), ids.end(), 1U);
    auto rows = model::IndividualRows::withDefaults(ids);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const bool isParked = i >= kPeople;
        const glm::vec3 at = isParked ? parked[i - kPeople] : glm::vec3(0.0F);
        rows.column(model::columns::templateId)[i] = isParked ? 2 : 1;
        rows.column(model::columns::path)[i] = isParked ? 0 : 1;
        rows.column(model::columns::heading)[i] = at.y;
        rows.column(model::columns::position)[i] =
            isParked ? glm::vec3(at.x, 0.0F, at.z)
                     : glm::vec3(static_cast<float>(i % 3) - 1.0F, 0.0F,
                                 -6.0F - 1.2F * static_cast<float>(i / 3));
    }
    scene.population.add(rows);
    Session session(scene);
    if (!scene.stages.empty()) {
        const auto surface = testing::surfaceOf(scene);
        QVERIFY(surface);
        session.setSurface(surface);
    }
    float least = 100.0F;
    for (int step = 0; step < 30 * 45; ++step) {
        session.step();
        const std::span<const Body> bodies = std::as_const(session.crowd()).bodies();
        for (const LongBody& horse : session.crowd().longBodies()) {
            for (std::size_t i = 0; i < kPeople; ++i) {
                least =
                    std::min(least, awayFrom(flatPlaceOf(bodies[i]), bodies[horse.agent], horse));
            }
        }
    }
    std::size_t past = 0;
    for (const Body& body : session.crowd().bodies().first(kPeople)) {
        past += body.z > 8.0F ? 1 : 0;
    }
    QCOMPARE(past, kPeople);
    QVERIFY2(least > 0.5F, qPrintable(QString::number(least)));
}

/// A field of parked ones, with as many people as are worth several threads.
void LongBodiesTest::detoursAreTheSameForAnyNumberOfThreads()
{
    model::Scene scene;
    scene.templates = {testing::actorTemplate(), horseTemplate(3.0F)};
    scene.places = {{.id = 1, .name = "end", .position = {40.0F, 0.0F, 200.0F}, .radius = 30.0F}};
    scene.paths = {{.id = 1, .name = "way", .places = {1}}};
    std::vector<model::IndividualId> ids(4000);
    std::iota(ids.begin(), ids.end(), 1U);
    auto rows = model::IndividualRows::withDefaults(ids);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const bool isParked = i % 20 == 0;
        rows.column(model::columns::templateId)[i] = isParked ? 2 : 1;
        rows.column(model::columns::path)[i] = isParked ? 0 : 1;
        rows.column(model::columns::heading)[i] = 1.3F;
        rows.column(model::columns::position)[i] = {static_cast<float>(i % 80) * 1.1F, 0.0F,
                                                    static_cast<float>(i / 80) * 1.3F};
    }
    scene.population.add(rows);
    const auto run = [&scene](int threads) {
        const model::ThreadLimit limit(threads);
        Session session(scene);
        for (int step = 0; step < 60; ++step) {
            session.step();
        }
        std::vector<std::uint32_t> bits;
        for (const Body& body : session.crowd().bodies()) {
            for (const float value : {body.x, body.z, body.velocityX, body.velocityZ}) {
                bits.push_back(std::bit_cast<std::uint32_t>(value));
            }
        }
        return bits;
    };
    QCOMPARE(run(1), run(4));
}

CROWD_TEST(LongBodiesTest)
#include "tst_LongBodies.moc"
