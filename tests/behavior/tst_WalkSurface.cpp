// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <QtTest/QTest>

#include "behavior/session/Session.h"
#include "behavior/surface/WalkSurface.h"
#include "model/base/Parallel.h"
#include "model/scene/PlaceShape.h"
#include "tests/behavior/BoxStage.h"
#include "tests/program/Test.h"

using namespace crowd;
using behavior::Session;
using behavior::WalkSurface;
using testing::addBox;
using testing::stageOf;
using testing::surfaceOf;

namespace {

/// A house 10 × 10 m and 6 m high around the origin.
model::StageEntry house()
{
    model::StageMesh mesh;
    addBox(mesh, {-5.0F, 0.0F, -5.0F}, {5.0F, 6.0F, 5.0F});
    return stageOf(mesh);
}

/// Stairs of ten steps of 0.2 m to a platform at 2 m.
model::StageEntry stairs()
{
    model::StageMesh mesh;
    for (int step = 0; step < 10; ++step) {
        const auto at = static_cast<float>(step);
        addBox(mesh, {-3.0F, 0.0F, at * 0.35F}, {3.0F, 0.2F * (at + 1.0F), 12.0F});
    }
    return stageOf(mesh);
}

std::shared_ptr<const WalkSurface> surfaceOf(const model::StageEntry& stage)
{
    WalkSurface::Progress progress;
    auto built = WalkSurface::build({{stage}, {}, {}, {}}, progress);
    if (!built) {
        qWarning("%s", built.error().message.c_str());
        return nullptr;
    }
    return built.value();
}

model::Scene walkerFrom(const glm::vec3& from, const glm::vec3& to)
{
    model::Scene scene;
    auto rows = model::IndividualRows::withDefaults({1});
    rows.column(model::columns::position)[0] = from;
    rows.column(model::columns::path)[0] = 1;
    scene.population.add(rows);
    scene.places = {{1, "to", to, 0.05F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1}}};
    return scene;
}

model::Place area(model::PlaceId id, float x, float z, float radius, model::PlaceRole role)
{
    return {id, "area", {x, 0.0F, z}, radius, {}, role};
}

model::Place shape(model::PlaceRole role, model::PlaceShape shape,
                   const std::vector<glm::vec3>& corners)
{
    model::Place place;
    place.id = 2;
    place.radius = 0.2F;
    place.role = role;
    place.shape = shape;
    model::setCorners(place, corners);
    return place;
}

glm::vec3 shownAt(const Session& session)
{
    return session.frame()->population.column(model::columns::position)[0];
}

float flatLength(const glm::vec3& at)
{
    return std::sqrt(at.x * at.x + at.z * at.z);
}

} // namespace

class TestWalkSurface : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void waysGoAroundAHouse();
    void aWalkerGoesAroundAHouse();
    void aPathIntoAHouseEndsBeforeIt();
    void stairsAreClimbed();
    void narrowWaysAreWalkedByWhoIsSlim_data();
    void narrowWaysAreWalkedByWhoIsSlim();
    void whereThereIsRoomOneKeepsOffTheWall();
    void alleysOnAWidePlainAreWalked();
    void isTheSameForAnyNumberOfThreads();
    void whyNobodyWalksIsSaid();
    void whatIsWalkableCanBeShown();
    void aPlaceWiderThanItsLevelIsReachedThere_data();
    void aPlaceWiderThanItsLevelIsReachedThere();
    void waysLeadAroundForbiddenGround();
    void waysPreferLikedGroundAndAvoidSlow();
    void obstaclesOnOpenGroundAreWalkedAround();
    void wallsAndFencesAreWalkedAround();
    void areasOfAnyShapeAreWalkedAround_data();
    void areasOfAnyShapeAreWalkedAround();
    void lanesAndLawnsAreOfAnyShape();
    void whoIsInANewObstacleStepsOut_data();
    void whoIsInANewObstacleStepsOut();
    void bodiesAndSlopesAreAsSet();
    void nothingToWalkOnIsSaid();
    void canBeCancelled();
    void noStageEndsTheProgram_data();
    void noStageEndsTheProgram();
};

void TestWalkSurface::waysGoAroundAHouse()
{
    const auto surface = surfaceOf(house());
    QVERIFY(surface);
    QVERIFY(surface->polygons() > 0);
    const auto way = surface->way({-9.0F, 0.0F, 0.0F}, {9.0F, 0.0F, 0.0F});
    QVERIFY(way.size() >= 3);
    QCOMPARE(way.back(), glm::vec2(9.0F, 0.0F));
    for (const glm::vec2& corner : way) {
        QVERIFY(std::max(std::abs(corner.x), std::abs(corner.y)) > 5.1F);
    }
    QVERIFY(std::abs(surface->height(-9.0F, 3.0F, 0.4F)) < 0.1F);
}

void TestWalkSurface::aWalkerGoesAroundAHouse()
{
    const auto surface = surfaceOf(house());
    QVERIFY(surface);
    Session session(walkerFrom({-9.0F, 0.0F, 0.5F}, {9.0F, 0.0F, 0.0F}));
    session.setSurface(surface);
    for (int step = 0; step < 30 * 40; ++step) {
        session.step();
        const auto frame = session.frame();
        const glm::vec3 at = frame->population.column(model::columns::position)[0];
        QVERIFY2(std::max(std::abs(at.x), std::abs(at.z)) > 5.0F,
                 QByteArray::number(static_cast<double>(at.x)));
    }
    const auto end = session.frame();
    const glm::vec3 at = end->population.column(model::columns::position)[0];
    QVERIFY2(std::abs(at.x - 9.0F) < 0.6F, QByteArray::number(static_cast<double>(at.x)));
    QVERIFY(session.tally().followers.empty());
}

void TestWalkSurface::aPathIntoAHouseEndsBeforeIt()
{
    const auto surface = surfaceOf(house());
    QVERIFY(surface);
    Session session(walkerFrom({-9.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}));
    session.setSurface(surface);
    for (int step = 0; step < 30 * 20; ++step) {
        session.step();
    }
    const auto end = session.frame();
    const glm::vec3 at = end->population.column(model::columns::position)[0];
    QVERIFY(std::isfinite(at.x) && at.x < -4.9F);
}

void TestWalkSurface::stairsAreClimbed()
{
    const auto surface = surfaceOf(stairs());
    QVERIFY(surface);
    Session session(walkerFrom({0.0F, 0.0F, -4.0F}, {0.0F, 2.0F, 9.0F}));
    session.setSurface(surface);
    float highest = 0.0F;
    for (int step = 0; step < 30 * 30; ++step) {
        session.step();
        const auto frame = session.frame();
        highest = std::max(highest, frame->population.column(model::columns::position)[0].y);
    }
    const auto end = session.frame();
    const glm::vec3 at = end->population.column(model::columns::position)[0];
    QVERIFY2(std::abs(at.y - 2.0F) < 0.12F, QByteArray::number(static_cast<double>(at.y)));
    QVERIFY(at.z > 8.0F);
    QVERIFY(highest < 2.2F);
}

void TestWalkSurface::narrowWaysAreWalkedByWhoIsSlim_data()
{
    QTest::addColumn<float>("gap");
    QTest::addColumn<float>("depth");
    QTest::addColumn<bool>("isPassed");
    QTest::newRow("between the seats") << 0.75F << 8.0F << true;
    QTest::newRow("a door") << 0.8F << 0.2F << true;
    QTest::newRow("wide enough for all") << 1.5F << 8.0F << true;
    QTest::newRow("a slit") << 0.3F << 8.0F << false;
}

void TestWalkSurface::narrowWaysAreWalkedByWhoIsSlim()
{
    QFETCH(float, gap);
    QFETCH(float, depth);
    QFETCH(bool, isPassed);
    model::StageMesh mesh;
    addBox(mesh, {-20.0F, 0.0F, 0.0F}, {-0.5F * gap, 3.0F, depth});
    addBox(mesh, {0.5F * gap, 0.0F, 0.0F}, {20.0F, 3.0F, depth});
    const auto surface = surfaceOf(stageOf(mesh));
    QVERIFY(surface != nullptr);
    const auto metres = surface->wayMetres({0.0F, 0.0F, -5.0F}, {0.0F, 0.0F, depth + 5.0F}, 1.0F);
    QVERIFY(metres.has_value());
    QVERIFY2((*metres < depth + 12.0F) == isPassed, qPrintable(QString::number(*metres)));
    QCOMPARE(surface->isWalkable({0.0F, 0.0F, 0.5F * depth}), isPassed);
}

void TestWalkSurface::whereThereIsRoomOneKeepsOffTheWall()
{
    const auto surface = surfaceOf(house());
    QVERIFY(surface != nullptr);
    for (const glm::vec2& corner :
         surface->way(glm::vec3(-9.0F, 0.0F, 0.5F), glm::vec3(9.0F, 0.0F, 0.5F))) {
        const float off = std::max(std::fabs(corner.x), std::fabs(corner.y)) - 5.0F;
        QVERIFY2(off > 0.28F, qPrintable(QString::number(off)));
    }
}

void TestWalkSurface::alleysOnAWidePlainAreWalked()
{
    model::StageMesh mesh;
    addBox(mesh, {-1024.0F, -1.0F, -1024.0F}, {1024.0F, 0.4F, 1024.0F});
    addBox(mesh, {-20.0F, 0.4F, 300.0F}, {-0.5F, 6.0F, 310.0F});
    addBox(mesh, {0.5F, 0.4F, 300.0F}, {20.0F, 6.0F, 310.0F});
    const auto surface = surfaceOf(stageOf(mesh));
    QVERIFY(surface != nullptr);
    QVERIFY(surface->isWalkable({0.0F, 0.4F, 305.0F}));
    for (const float x : {-1000.0F, -301.0F, 0.0F, 777.0F}) {
        QVERIFY(surface->isWalkable({x, 0.4F, -500.0F}));
    }
    const auto metres = surface->wayMetres({0.0F, 0.4F, -900.0F}, {0.0F, 0.4F, 900.0F}, 1.0F);
    QVERIFY(metres.has_value());
    QVERIFY2(*metres < 1805.0F, qPrintable(QString::number(*metres)));
}

void TestWalkSurface::isTheSameForAnyNumberOfThreads()
{
    model::StageMesh mesh;
    for (int house = 0; house < 12; ++house) {
        const auto x = static_cast<float>(house % 4) * 21.7F;
        const auto z = static_cast<float>(house / 4) * 18.3F;
        addBox(mesh, {x, 0.0F, z}, {x + 9.0F, 5.0F, z + 7.0F});
    }
    const auto many = surfaceOf(stageOf(mesh));
    const model::ThreadLimit one(1);
    const auto single = surfaceOf(stageOf(mesh));
    QVERIFY(many != nullptr && single != nullptr);
    QCOMPARE(single->polygons(), many->polygons());
    QVERIFY(single->triangles() == many->triangles());
}

void TestWalkSurface::whyNobodyWalksIsSaid()
{
    using model::WalkRefusal;
    model::StageMesh mesh;
    addBox(mesh, {-5.0F, 0.0F, -5.0F}, {5.0F, 6.0F, 5.0F});    // a house
    addBox(mesh, {9.0F, 1.4F, -5.0F}, {15.0F, 1.6F, 5.0F});    // a table for giants
    addBox(mesh, {-16.0F, 0.0F, -3.0F}, {-12.0F, 1.5F, 3.0F}); // a platform without steps
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3 corner : {glm::vec3(-4.0F, 0.0F, 10.0F), glm::vec3(-4.0F, 8.0F, 15.0F),
                                   glm::vec3(4.0F, 8.0F, 15.0F), glm::vec3(4.0F, 0.0F, 10.0F)}) {
        mesh.positions.push_back(corner);
    }
    for (const std::uint32_t index : {0U, 1U, 2U, 0U, 2U, 3U}) {
        mesh.indices.push_back(first + index);
    }
    const auto surface = surfaceOf(stageOf(mesh));
    QVERIFY(surface != nullptr);
    QCOMPARE(surface->refusal({8.0F, 0.0F, 0.0F}), WalkRefusal::None);
    QCOMPARE(surface->refusal({0.0F, 4.0F, 12.5F}), WalkRefusal::Steep);
    QCOMPARE(surface->refusal({12.0F, 0.0F, 0.0F}), WalkRefusal::Low);
    QCOMPARE(surface->refusal({5.02F, 0.0F, 0.0F}), WalkRefusal::Narrow);
    QCOMPARE(surface->refusal({-14.0F, 1.5F, 0.0F}), WalkRefusal::Unlinked);
    QCOMPARE(surface->refusal({0.0F, 6.0F, 0.0F}), WalkRefusal::Unlinked);
}

void TestWalkSurface::whatIsWalkableCanBeShown()
{
    const auto surface = surfaceOf(house());
    QVERIFY(surface != nullptr);
    const auto triangles = surface->triangles();
    QVERIFY(!triangles.empty());
    float nearest = 100.0F;
    for (const auto& corners : triangles) {
        for (const glm::vec3& corner : corners) {
            QVERIFY(std::fabs(corner.y) < 0.15F);
            nearest = std::min(nearest, std::max(std::fabs(corner.x), std::fabs(corner.z)) - 5.0F);
        }
    }
    QVERIFY2(nearest > 0.2F && nearest < 0.5F, qPrintable(QString::number(nearest)));
}

void TestWalkSurface::aPlaceWiderThanItsLevelIsReachedThere_data()
{
    QTest::addColumn<bool>("byRule");
    QTest::newRow("on a path") << false;
    QTest::newRow("sent by a rule") << true;
}

/// Everybody has a point of his own in the place; none of them is beside the stairs.
void TestWalkSurface::aPlaceWiderThanItsLevelIsReachedThere()
{
    QFETCH(const bool, byRule);
    constexpr std::size_t kPeople = 12;
    model::Scene scene = walkerFrom({}, {0.0F, 2.0F, 7.0F});
    scene.stages = {stairs()};
    scene.places[0].radius = 5.0F;
    std::vector<model::IndividualId> ids(kPeople);
    std::iota(ids.begin(), ids.end(), 1U);
    (void)scene.population.remove(std::vector<model::IndividualId>{1});
    auto rows = model::IndividualRows::withDefaults(ids);
    for (std::size_t i = 0; i < kPeople; ++i) {
        rows.column(model::columns::position)[i] = {static_cast<float>(i) - 5.5F, 0.0F, -4.0F};
        rows.column(model::columns::path)[i] = byRule ? 0 : 1;
    }
    scene.population.add(rows);
    if (byRule) {
        model::Rule go;
        go.id = 1;
        go.trigger = model::triggers::Start();
        model::actions::GoToPlace there;
        there.place = 1;
        go.actions = {there};
        scene.rules = {go};
    }
    Session session(scene);
    session.setSurface(surfaceOf(scene));
    for (int step = 0; step < 30 * 40; ++step) {
        session.step();
    }
    const auto frame = session.frame();
    for (const glm::vec3& at : frame->population.column(model::columns::position)) {
        QVERIFY2(at.y > 0.5F, // or still on the stairs, which are part of the place
                 qPrintable(QStringLiteral("%1 %2 %3").arg(at.x).arg(at.y).arg(at.z)));
    }
}

void TestWalkSurface::waysLeadAroundForbiddenGround()
{
    model::Scene scene = walkerFrom({-9.0F, 0.0F, 0.0F}, {9.0F, 0.0F, 0.0F});
    scene.places.push_back(area(2, 0.0F, 0.0F, 4.0F, model::PlaceRole::Forbidden));
    const auto surface = surfaceOf(scene);
    QVERIFY(surface);
    QVERIFY(surface->walls().empty()); // nobody is held back who is pushed
    QVERIFY(surface->way({-9.0F, 0.0F, 0.0F}, {9.0F, 0.0F, 0.0F}).size() >= 3);
    Session session(scene);
    session.setSurface(surface);
    float nearest = 100.0F;
    for (int step = 0; step < 30 * 25; ++step) {
        session.step();
        nearest = std::min(nearest, flatLength(shownAt(session)));
    }
    QVERIFY2(nearest > 3.8F, QByteArray::number(static_cast<double>(nearest)));
    QVERIFY(std::abs(shownAt(session).x - 9.0F) < 0.6F);
    // Who stands in it gets out of it.
    scene = walkerFrom({1.0F, 0.0F, 0.0F}, {9.0F, 0.0F, 0.0F});
    scene.places.push_back(area(2, 0.0F, 0.0F, 4.0F, model::PlaceRole::Forbidden));
    Session inside(scene);
    inside.setSurface(surfaceOf(scene));
    for (int step = 0; step < 30 * 12; ++step) {
        inside.step();
    }
    QVERIFY(std::abs(shownAt(inside).x - 9.0F) < 0.6F);
}

void TestWalkSurface::waysPreferLikedGroundAndAvoidSlow()
{
    const auto lengthThrough = [](model::PlaceRole role, float share) {
        // Two ways past a wall: straight ahead, or a little longer by the side.
        model::Scene scene = walkerFrom({-12.0F, 0.0F, 0.0F}, {12.0F, 0.0F, 0.0F});
        scene.places.push_back(area(2, 0.0F, 0.0F, 5.0F, role));
        scene.places.back().speedShare = share;
        const auto surface = surfaceOf(scene);
        float farthest = 0.0F;
        for (const glm::vec2& corner : surface->way({-12.0F, 0.0F, 0.0F}, {12.0F, 0.0F, 0.0F})) {
            farthest = std::max(farthest, std::abs(corner.y));
        }
        return farthest;
    };
    QVERIFY(lengthThrough(model::PlaceRole::Slow, 0.1F) > 3.0F);
    QVERIFY(lengthThrough(model::PlaceRole::Slow, 1.0F) < 1.0F);
    QVERIFY(lengthThrough(model::PlaceRole::Preferred, 0.5F) < 1.0F);
    // The speed is as the place says.
    model::Scene scene = walkerFrom({-2.0F, 0.0F, 0.0F}, {9.0F, 0.0F, 0.0F});
    scene.places.push_back(area(2, 0.0F, 0.0F, 6.0F, model::PlaceRole::Slow));
    scene.places.back().speedShare = 0.25F;
    Session session(scene);
    for (int step = 0; step < 120; ++step) {
        session.step();
    }
    const float walked = shownAt(session).x + 2.0F;
    QVERIFY2(walked > 0.8F && walked < 1.6F, QByteArray::number(static_cast<double>(walked)));
}

void TestWalkSurface::obstaclesOnOpenGroundAreWalkedAround()
{
    model::Scene scene = walkerFrom({-9.0F, 0.0F, 0.0F}, {9.0F, 0.0F, 0.0F});
    scene.places.push_back(area(2, 0.0F, 0.0F, 4.0F, model::PlaceRole::Obstacle));
    const auto surface = surfaceOf(scene);
    QVERIFY(surface);
    Session session(scene);
    session.setSurface(surface);
    for (int step = 0; step < 30 * 25; ++step) {
        session.step();
        QVERIFY(flatLength(shownAt(session)) > 3.8F);
    }
    QVERIFY(std::abs(shownAt(session).x - 9.0F) < 0.6F);
}

/// A fence with a bend, up over a slope that nobody else would notice.
void TestWalkSurface::wallsAndFencesAreWalkedAround()
{
    model::Scene scene = walkerFrom({-9.0F, 0.0F, 0.0F}, {9.0F, 0.0F, 0.0F});
    scene.places.push_back(shape(model::PlaceRole::Obstacle, model::PlaceShape::Line,
                                 {{-2.0F, 0.0F, -7.0F}, {1.0F, 0.0F, 0.0F}, {-2.0F, 0.0F, 5.0F}}));
    Session session(scene);
    session.setSurface(surfaceOf(scene));
    float side = 0.0F;
    for (int step = 0; step < 30 * 30; ++step) {
        session.step();
        const glm::vec3 at = shownAt(session);
        QVERIFY2(!model::isWithin(scene.places.back(), at),
                 qPrintable(QStringLiteral("%1 %2").arg(at.x).arg(at.z)));
        side = std::max(side, at.z);
    }
    QVERIFY2(side > 5.0F && side < 7.0F, QByteArray::number(static_cast<double>(side)));
    QVERIFY(std::abs(shownAt(session).x - 9.0F) < 0.6F);
}

void TestWalkSurface::areasOfAnyShapeAreWalkedAround_data()
{
    QTest::addColumn<bool>("isReversed");
    QTest::newRow("clockwise") << false;
    QTest::newRow("the other way round") << true;
}

/// A U, open to where he comes from: he does not go into it.
void TestWalkSurface::areasOfAnyShapeAreWalkedAround()
{
    QFETCH(const bool, isReversed);
    std::vector<glm::vec3> corners{{-3, 0, -4}, {3, 0, -4}, {3, 0, 4},  {-3, 0, 4},
                                   {-3, 0, 3},  {2, 0, 3},  {2, 0, -3}, {-3, 0, -3}};
    if (isReversed) {
        std::ranges::reverse(corners);
    }
    model::Scene scene = walkerFrom({-9.0F, 0.0F, 0.0F}, {9.0F, 0.0F, 0.0F});
    scene.places.push_back(shape(model::PlaceRole::Obstacle, model::PlaceShape::Area, corners));
    const auto surface = surfaceOf(scene);
    QVERIFY(surface->isWalkable({0.0F, 0.0F, 0.0F})); // within its arms
    QVERIFY(!surface->isWalkable({0.0F, 0.0F, 3.5F}));
    Session session(scene);
    session.setSurface(surface);
    for (int step = 0; step < 30 * 25; ++step) {
        session.step();
        QVERIFY(!model::isEnclosed(model::cornersOf(scene.places.back()),
                                   {shownAt(session).x, shownAt(session).z}));
    }
    QVERIFY(std::abs(shownAt(session).x - 9.0F) < 0.6F);
}

void TestWalkSurface::lanesAndLawnsAreOfAnyShape()
{
    // Forbidden: around it.
    model::Scene scene = walkerFrom({-9.0F, 0.0F, 0.0F}, {9.0F, 0.0F, 0.0F});
    scene.places.push_back(shape(model::PlaceRole::Forbidden, model::PlaceShape::Area,
                                 {{-3, 0, -3}, {3, 0, -3}, {3, 0, 6}, {-3, 0, 6}}));
    float least = 0.0F;
    for (const glm::vec2& corner : surfaceOf(scene)->way({-9.0F, 0.0F, 0.0F}, {9.0F, 0.0F, 0.0F})) {
        least = std::min(least, corner.y);
    }
    QVERIFY2(least < -2.9F, QByteArray::number(static_cast<double>(least)));
    // Slow: only on it.
    scene = walkerFrom({-6.0F, 0.0F, 0.0F}, {9.0F, 0.0F, 0.0F});
    scene.places.push_back(shape(model::PlaceRole::Slow, model::PlaceShape::Line,
                                 {{0.0F, 0.0F, -30.0F}, {0.0F, 0.0F, 30.0F}}));
    scene.places.back().radius = 1.0F;
    scene.places.back().speedShare = 0.25F;
    Session session(scene);
    int slow = 0;
    int usual = 0;
    for (int step = 0; step < 30 * 14; ++step) {
        const float before = shownAt(session).x;
        session.step();
        const float metres = 30.0F * (shownAt(session).x - before);
        const float off = std::abs(shownAt(session).x);
        slow += off < 0.7F && metres < 0.6F ? 1 : 0;
        usual += off > 2.0F && metres > 1.0F ? 1 : 0;
    }
    QVERIFY2(slow > 60, QByteArray::number(slow));
    QVERIFY2(usual > 60, QByteArray::number(usual));
}

void TestWalkSurface::whoIsInANewObstacleStepsOut_data()
{
    QTest::addColumn<float>("ahead");
    QTest::newRow("in its middle") << 0.0F;
    QTest::newRow("where he came in") << 2.0F;
    QTest::newRow("where he wants out") << -2.0F;
}

void TestWalkSurface::whoIsInANewObstacleStepsOut()
{
    QFETCH(const float, ahead);
    model::Scene scene = walkerFrom({-9.0F, 0.0F, 0.0F}, {12.0F, 0.0F, 0.0F});
    Session session(scene);
    for (int step = 0; step < 30 * 5; ++step) {
        session.step();
    }
    const float middle = shownAt(session).x + ahead;
    scene.places.push_back(area(2, middle, 0.0F, 2.5F, model::PlaceRole::Obstacle));
    session.adopt(scene);
    session.setSurface(surfaceOf(scene));
    const auto isInside = [&] {
        return flatLength(shownAt(session) - glm::vec3(middle, 0.0F, 0.0F)) < 2.3F;
    };
    int stepsInside = 0;
    for (int step = 0; step < 30 * 25; ++step) {
        session.step();
        QVERIFY(!isInside() || stepsInside == step); // nor comes back
        stepsInside += isInside() ? 1 : 0;
    }
    QVERIFY2(stepsInside < 30 * 5, QByteArray::number(stepsInside));
    QVERIFY(std::abs(shownAt(session).x - 12.0F) < 0.6F);
}

void TestWalkSurface::bodiesAndSlopesAreAsSet()
{
    model::Scene scene;
    scene.stages = {stairs()};
    QVERIFY(surfaceOf(scene)->reaches({0.0F, 2.0F, 9.0F}, 1.0F));
    const std::size_t usual = surfaceOf(scene)->way({0.0F, 0.0F, -4.0F}, {0.0F, 2.0F, 9.0F}).size();
    QVERIFY(usual > 0);
    scene.surface.climb = 0.1F; // no step is low enough
    const auto low = surfaceOf(scene);
    QVERIFY(low);
    const auto way = low->way({0.0F, 0.0F, -4.0F}, {0.0F, 2.0F, 9.0F});
    const auto isOnStairs = [](const glm::vec2& at) {
        return at.y > 0.1F && at.y < 11.9F && std::abs(at.x) < 2.9F;
    };
    QVERIFY(way.empty() || !isOnStairs(way.back()));
    QVERIFY(!behavior::SurfacePlan::of(scene).hasSameWays({}));
}

void TestWalkSurface::nothingToWalkOnIsSaid()
{
    WalkSurface::Progress progress;
    const auto built = WalkSurface::build({}, progress);
    QVERIFY(!built.isOk());
    QVERIFY(built.error().message.find("no stage") != std::string::npos);
}

void TestWalkSurface::canBeCancelled()
{
    WalkSurface::Progress progress;
    progress.isCancelled = true;
    const auto built = WalkSurface::build({{house()}, {}, {}, {}}, progress);
    QVERIFY(!built.isOk());
    QVERIFY(built.error().message.find("cancelled") != std::string::npos);
}

void TestWalkSurface::noStageEndsTheProgram_data()
{
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    QTest::addColumn<std::vector<glm::vec3>>("corners"); // of triangles beside a house
    QTest::addColumn<bool>("isHouseThere");
    const auto row = [](const char* name, std::vector<glm::vec3> corners,
                        bool isHouseThere = true) {
        QTest::newRow(name) << std::move(corners) << isHouseThere;
    };
    row("no triangle", {}, false);
    row("no number", {{kNone, 0.0F, 0.0F}, {1.0F, kNone, 0.0F}, {0.0F, 0.0F, kNone}});
    row("infinities", {{kInfinity, 0.0F, 0.0F}, {0.0F, -kInfinity, 0.0F}, {0.0F, 1.0F, 1.0F}});
    row("the largest numbers", {{3e38F, 0.0F, 0.0F}, {0.0F, 3e38F, 0.0F}, {0.0F, 0.0F, -3e38F}});
    row("light years", {{1e13F, 0.0F, 1e13F}, {-1e13F, 0.0F, 1e13F}, {0.0F, 0.0F, -1e13F}});
    row("from pole to pole", {{-9e6F, 0.0F, -9e6F}, {-9e6F, 0.0F, 9e6F}, {9e6F, 0.0F, 0.0F}});
    row("a strip around the earth", {{-9e6F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F}, {9e6F, 0.0F, 0.0F}});
    row("a tower into the sky", {{0.0F, -9e6F, 0.0F}, {1.0F, 9e6F, 0.0F}, {0.0F, 9e6F, 1.0F}});
    row("points", {glm::vec3(8.0F), glm::vec3(8.0F), glm::vec3(8.0F)});
    row("nothing but a point", {glm::vec3(0.0F), glm::vec3(0.0F), glm::vec3(0.0F)}, false);
    row("a line", {{8.0F, 1.0F, 8.0F}, {9.0F, 1.0F, 8.0F}, {10.0F, 1.0F, 8.0F}});
    std::vector<glm::vec3> many;
    for (int i = 0; i < 600; ++i) {
        const auto at = static_cast<float>(i);
        many.emplace_back(std::fmod(at * 7.31F, 90.0F), std::fmod(at * 3.77F, 40.0F),
                          std::fmod(at * 5.93F, 80.0F));
    }
    row("a heap of splinters", many);
}

/// Recast asserts: what it cannot reckon with must not come to it.
void TestWalkSurface::noStageEndsTheProgram()
{
    QFETCH(const std::vector<glm::vec3>, corners);
    QFETCH(const bool, isHouseThere);
    model::StageMesh mesh;
    if (isHouseThere) {
        addBox(mesh, {-5.0F, 0.0F, -5.0F}, {5.0F, 6.0F, 5.0F});
    }
    for (const glm::vec3& corner : corners) {
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.push_back(corner);
    }
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    behavior::SurfacePlan plan{{stageOf(mesh)}, {{kNone, 0.0F, kInfinity}}, {}, {}};
    for (const float odd : {0.35F, kNone, kInfinity, -3e38F}) {
        plan.settings = {odd, 5.0F * odd, odd, 100.0F * odd};
        plan.areas = {area(1, 8.0F, 8.0F, std::fabs(odd), model::PlaceRole::Slow),
                      area(2, 1e12F, -1e12F, 2.0F, model::PlaceRole::Obstacle)};
        WalkSurface::Progress progress;
        const auto built = WalkSurface::build(plan, progress);
        QVERIFY(built.isOk() || !built.error().message.empty());
        if (!built) {
            continue;
        }
        const WalkSurface& surface = *built.value();
        for (const glm::vec3& at : {glm::vec3(-9.0F, 0.0F, 0.0F), glm::vec3(kNone),
                                    glm::vec3(kInfinity), glm::vec3(0.0F, 3e38F, -3e38F)}) {
            (void)surface.way({-9.0F, 0.0F, 0.0F}, at);
            (void)surface.way(at, {-9.0F, 0.0F, 0.0F});
            (void)surface.wayMetres(at, {9.0F, 0.0F, 0.0F}, 1.0F);
            (void)surface.height(at.x, at.z, at.y);
            (void)surface.isWalkable(at);
            (void)surface.nearest(at);
            const auto reached = surface.straight({-9.0F, 0.0F, 0.0F}, at);
            QVERIFY(!reached || model::Bounds::isPlace(*reached));
        }
    }
}

CROWD_TEST(TestWalkSurface)
#include "tst_WalkSurface.moc"
