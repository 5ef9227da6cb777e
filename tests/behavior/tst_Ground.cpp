// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "behavior/session/Session.h"
#include "behavior/surface/WalkSurface.h"
#include "tests/behavior/BoxStage.h"
#include "tests/program/Test.h"

using namespace crowd;
using behavior::Session;
using behavior::SurfacePlan;
using behavior::WalkSurface;
using testing::addBox;
using testing::stageOf;

namespace {

using SurfacePtr = std::shared_ptr<const WalkSurface>;

SurfacePtr surfaceFor(const SurfacePlan& plan)
{
    WalkSurface::Progress progress;
    auto built = WalkSurface::build(plan, progress);
    return built ? built.value() : nullptr;
}

model::Scene sceneOn(const model::StageMesh& mesh)
{
    model::Scene scene;
    scene.stages = {stageOf(mesh)};
    return scene;
}

/// Everybody at a foot point, all on path 1 but for those whose path is given.
void addPeople(model::Scene& scene, const std::vector<glm::vec3>& points,
               const std::vector<model::PathId>& paths = {})
{
    std::vector<model::IndividualId> ids(points.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
        ids[i] = static_cast<model::IndividualId>(i + 1);
    }
    auto rows = model::IndividualRows::withDefaults(ids);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        rows.column(model::columns::position)[i] = points[i];
        rows.column(model::columns::path)[i] = i < paths.size() ? paths[i] : 1;
        rows.column(model::columns::walkSpeed)[i] = 1.3F;
        rows.column(model::columns::seed)[i] = 100U + static_cast<std::uint32_t>(i);
    }
    scene.population.add(rows);
}

void addPath(model::Scene& scene, model::PathId id, const std::vector<glm::vec3>& points,
             float radius)
{
    model::Path path{id, "path", model::PathKind::Simple, {}};
    for (const glm::vec3& point : points) {
        const auto place = static_cast<model::PlaceId>(scene.places.size() + 1);
        scene.places.push_back({place, "place", point, radius});
        path.places.push_back(place);
    }
    scene.paths.push_back(path);
}

/// A slope along X from one height to another, 4 m wide, with sides down to the ground.
void addRamp(model::StageMesh& mesh, float x0, float y0, float x1, float y1)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const float z : {-2.0F, 2.0F}) {
        mesh.positions.emplace_back(x0, y0, z);
        mesh.positions.emplace_back(x1, y1, z);
        mesh.positions.emplace_back(x0, 0.0F, z);
        mesh.positions.emplace_back(x1, 0.0F, z);
    }
    const bool isRightwards = x1 > x0;
    for (const auto& quad :
         {std::array<std::uint32_t, 4>{0, 4, 5, 1}, {0, 1, 3, 2}, {4, 6, 7, 5}}) {
        for (const int corner : {0, 1, 2, 0, 2, 3}) {
            const auto at = static_cast<std::size_t>(isRightwards ? corner : (4 - corner) % 4);
            mesh.indices.push_back(first + quad[at]);
        }
    }
}

/// A bridge along X, 3.6 m high, with a ramp at either end; one can walk below it.
model::StageMesh bridge()
{
    model::StageMesh mesh;
    addBox(mesh, {-6.0F, 3.4F, -2.0F}, {6.0F, 3.6F, 2.0F});
    addRamp(mesh, -16.0F, 0.0F, -6.0F, 3.6F);
    addRamp(mesh, 16.0F, 0.0F, 6.0F, 3.6F);
    return mesh;
}

std::span<const glm::vec3> shownPositions(const model::CrowdFramePtr& frame)
{
    return frame->population.column(model::columns::position);
}

} // namespace

class TestGround : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyWhatIsLinkedIsGround_data();
    void onlyWhatIsLinkedIsGround();
    void theNearestGroundIsBelowOrBeside();
    void theGroundIsTheSameWhoeverIsThere();
    void feetAreAtTheHeightOfWhatIsBelow();
    void whoComesToRestStandsOnTheGround();
    void stairsAreWalkedOnTheirSteps();
    void nobodyGetsUnderABridgeThatHeIsToCross();
    void whoIsInANewObstacleLeavesAtAWalk();
    void aFlowStaysWideAroundAPillar();
    void opposingFlowsGetPastEachOtherAtAFountain();
    void whoeverCannotWalkAwayIsNamed();
};

void TestGround::onlyWhatIsLinkedIsGround_data()
{
    QTest::addColumn<int>("stage");
    QTest::addColumn<float>("x");
    QTest::addColumn<float>("y");
    QTest::addColumn<bool>("isGround");
    QTest::newRow("the street before a house") << 0 << -8.0F << 0.0F << true;
    QTest::newRow("the roof of a house") << 0 << 0.0F << 6.0F << false;
    QTest::newRow("the inside of a house that has none") << 0 << 0.0F << 0.0F << false;
    QTest::newRow("the floor of a hall without doors") << 4 << 0.0F << 0.0F << true;
    QTest::newRow("in the air") << 0 << -8.0F << 5.5F << false;
    QTest::newRow("far out on open ground") << 0 << -300.0F << 0.0F << true;
    QTest::newRow("far out in the air") << 0 << -300.0F << 2.0F << false;
    QTest::newRow("in a basin") << 1 << 0.0F << 0.3F << false;
    QTest::newRow("on its rim") << 1 << 3.2F << 0.7F << false;
    QTest::newRow("beside it") << 1 << 6.0F << 0.0F << true;
    QTest::newRow("a platform that is the stage") << 2 << 0.0F << 1.0F << true;
    QTest::newRow("the deck of a bridge") << 3 << 0.0F << 3.6F << true;
    QTest::newRow("below it") << 3 << 0.0F << 0.0F << true;
    QTest::newRow("between both") << 3 << 0.0F << 1.8F << false;
}

void TestGround::onlyWhatIsLinkedIsGround()
{
    QFETCH(const int, stage);
    QFETCH(const float, x);
    QFETCH(const float, y);
    model::StageMesh meshes[5];
    addBox(meshes[0], {-5.0F, 0.0F, -5.0F}, {5.0F, 6.0F, 5.0F});
    addBox(meshes[1], {-3.0F, 0.0F, -3.0F}, {3.0F, 0.3F, 3.0F});
    for (const float side : {-3.2F, 3.2F}) {
        addBox(meshes[1], {side - 0.2F, 0.0F, -3.4F}, {side + 0.2F, 0.7F, 3.4F});
        addBox(meshes[1], {-3.4F, 0.0F, side - 0.2F}, {3.4F, 0.7F, side + 0.2F});
    }
    addBox(meshes[1], {-0.5F, 0.0F, -40.0F}, {0.5F, 4.0F, -39.0F}); // it is not the whole stage
    addBox(meshes[2], {-10.0F, 0.0F, -10.0F}, {10.0F, 1.0F, 10.0F});
    meshes[3] = bridge();
    addBox(meshes[4], {-5.0F, 0.0F, -5.0F}, {5.0F, 6.0F, 5.0F});
    std::ranges::reverse(meshes[4].indices); // made to be seen from inside
    const SurfacePtr surface = surfaceFor(SurfacePlan::ofStages(sceneOn(meshes[stage])));
    QVERIFY(surface);
    QTEST(surface->isWalkable({x, y, 0.0F}), "isGround");
}

void TestGround::theNearestGroundIsBelowOrBeside()
{
    model::StageMesh mesh;
    addBox(mesh, {-5.0F, 0.0F, -5.0F}, {5.0F, 6.0F, 5.0F});
    addBox(mesh, {-40.0F, 0.0F, -40.0F}, {-39.0F, 6.0F, -39.0F}); // it is not the whole stage
    const SurfacePtr surface = surfaceFor(SurfacePlan::ofStages(sceneOn(mesh)));
    QVERIFY(surface);
    QCOMPARE(surface->nearest({-8.0F, 5.5F, 1.0F}).value(), glm::vec3(-8.0F, 0.0F, 1.0F));
    QCOMPARE(surface->nearest({-8.0F, 0.0F, 1.0F}).value(), glm::vec3(-8.0F, 0.0F, 1.0F));
    const glm::vec3 beside = surface->nearest({4.0F, 6.0F, 0.0F}).value();
    QVERIFY2(beside.x > 5.2F && beside.x < 6.2F && std::fabs(beside.z) < 0.5F && beside.y == 0.0F,
             qPrintable(QStringLiteral("%1 %2 %3").arg(beside.x).arg(beside.y).arg(beside.z)));
    QVERIFY(surface->isWalkable(beside));
}

void TestGround::theGroundIsTheSameWhoeverIsThere()
{
    model::StageMesh mesh;
    addBox(mesh, {-5.03F, 0.0F, -5.01F}, {5.0F, 6.0F, 5.0F});
    model::Scene scene = sceneOn(mesh);
    const SurfacePtr alone = surfaceFor(SurfacePlan::of(scene));
    addPeople(scene, {{-17.3F, 0.0F, 12.1F}, {8.2F, 3.0F, -19.0F}});
    const SurfacePtr among = surfaceFor(SurfacePlan::of(scene));
    QVERIFY(alone && among);
    QCOMPARE(among->polygons(), alone->polygons());
    QCOMPARE(among->walls().size(), alone->walls().size());
    for (std::size_t i = 0; i < alone->walls().size(); ++i) {
        QCOMPARE(among->walls()[i].a, alone->walls()[i].a);
    }
}

void TestGround::feetAreAtTheHeightOfWhatIsBelow()
{
    // A street, a kerb of 15 cm at x = 0, and a planter of 40 cm further on, beside the way.
    model::StageMesh mesh;
    addBox(mesh, {-15.0F, -0.2F, -10.0F}, {0.0F, 0.013F, 10.0F});
    addBox(mesh, {0.0F, -0.2F, -10.0F}, {15.0F, 0.163F, 10.0F});
    addBox(mesh, {5.0F, 0.0F, 0.7F}, {8.0F, 0.56F, 3.0F});
    model::Scene scene = sceneOn(mesh);
    addPeople(scene, {{-8.0F, 0.013F, 0.0F}});
    addPath(scene, 1, {{10.0F, 0.163F, 0.0F}}, 0.05F);
    Session session(scene);
    session.setSurface(surfaceFor(SurfacePlan::of(scene)));
    for (int step = 0; step < 30 * 20; ++step) {
        session.step();
        const auto frame = session.frame();
        const glm::vec3 at = shownPositions(frame)[0];
        if (std::fabs(at.x) > 0.8F) { // he has come over the kerb
            const float ground = at.x < 0.0F ? 0.013F : 0.163F;
            QVERIFY2(std::fabs(at.y - ground) < 0.004F,
                     qPrintable(QStringLiteral("%1 at %2").arg(at.y).arg(at.x)));
        }
    }
    const auto frame = session.frame();
    QVERIFY(shownPositions(frame)[0].x > 9.0F);
}

void TestGround::whoComesToRestStandsOnTheGround()
{
    model::StageMesh mesh;
    addBox(mesh, {-15.0F, -0.2F, -10.0F}, {0.0F, 0.0F, 10.0F});
    addBox(mesh, {0.0F, -0.2F, -10.0F}, {15.0F, 0.3F, 10.0F});
    model::Scene scene = sceneOn(mesh);
    addPeople(scene, {{-4.0F, 0.0F, 0.0F}, {-6.0F, 0.1F, 3.0F}}, {1, 0});
    addPath(scene, 1, {{0.6F, 0.3F, 0.0F}}, 0.05F); // right behind the step
    Session session(scene);
    session.setSurface(surfaceFor(SurfacePlan::of(scene)));
    for (int step = 0; step < 30 * 10; ++step) {
        session.step();
    }
    const auto frame = session.frame();
    const glm::vec3 at = shownPositions(frame)[0];
    QVERIFY2(at.x > 0.0F, qPrintable(QString::number(at.x)));
    QVERIFY2(std::fabs(at.y - 0.3F) < 0.002F, qPrintable(QString::number(at.y)));
    QCOMPARE(shownPositions(frame)[1].y, 0.1F); // who never moved is where the artist put him
}

void TestGround::stairsAreWalkedOnTheirSteps()
{
    model::StageMesh mesh;
    for (int step = 0; step < 10; ++step) {
        const auto at = static_cast<float>(step);
        addBox(mesh, {-3.0F, 0.0F, at * 0.35F}, {3.0F, 0.17F * (at + 1.0F), 12.0F});
    }
    model::Scene scene = sceneOn(mesh);
    addPeople(scene, {{0.0F, 0.0F, -4.0F}});
    addPath(scene, 1, {{0.0F, 1.7F, 9.0F}}, 0.05F);
    Session session(scene);
    session.setSurface(surfaceFor(SurfacePlan::of(scene)));
    float deepest = 0.0F;
    float highest = 0.0F;
    for (int step = 0; step < 30 * 15; ++step) {
        session.step();
        const auto frame = session.frame();
        const glm::vec3 at = shownPositions(frame)[0];
        const float tread =
            at.z < 0.0F ? 0.0F : 0.17F * std::min(10.0F, std::floor(at.z / 0.35F) + 1.0F);
        deepest = std::max(deepest, tread - at.y);
        highest = std::max(highest, at.y - tread);
    }
    const auto frame = session.frame();
    QVERIFY(std::fabs(shownPositions(frame)[0].y - 1.7F) < 0.002F);
    QVERIFY2(deepest < 0.08F, qPrintable(QString::number(deepest)));
    QVERIFY2(highest < 0.17F, qPrintable(QString::number(highest)));
}

void TestGround::nobodyGetsUnderABridgeThatHeIsToCross()
{
    model::Scene scene = sceneOn(bridge());
    std::vector<glm::vec3> points;
    std::vector<model::PathId> paths;
    for (int i = 0; i < 80; ++i) {
        const float side = i % 2 == 0 ? 1.0F : -1.0F;
        const auto row = static_cast<float>(i / 2);
        points.emplace_back(-side * (18.0F + 0.9F * std::floor(row / 5.0F)), 0.0F,
                            std::fmod(row, 5.0F) * 1.4F - 2.8F);
        paths.push_back(i % 2 == 0 ? 1 : 2);
    }
    addPeople(scene, points, paths);
    addPath(scene, 1, {{-16.0F, 0.0F, 0.0F}, {0.0F, 3.6F, 0.0F}, {18.0F, 0.0F, 0.0F}}, 1.2F);
    addPath(scene, 2, {{16.0F, 0.0F, 0.0F}, {0.0F, 3.6F, 0.0F}, {-18.0F, 0.0F, 0.0F}}, 1.2F);
    Session session(scene);
    session.setSurface(surfaceFor(SurfacePlan::of(scene)));
    std::vector<int> above(points.size(), 0);
    for (int step = 0; step < 30 * 90; ++step) {
        session.step();
        if (step % 10 != 0) {
            continue;
        }
        const auto frame = session.frame();
        const auto at = shownPositions(frame);
        for (std::size_t i = 0; i < at.size(); ++i) {
            above[i] = at[i].y > 2.5F ? 1 : above[i];
            // He may walk around the foot of a ramp, not below the deck.
            QVERIFY2(std::fabs(at[i].x) > 3.0F || std::fabs(at[i].z) > 2.5F || at[i].y > 3.0F,
                     qPrintable(QStringLiteral("%1 at %2 %3 %4, second %5")
                                    .arg(i)
                                    .arg(at[i].x)
                                    .arg(at[i].y)
                                    .arg(at[i].z)
                                    .arg(step / 30)));
        }
    }
    QVERIFY(std::ranges::count(above, 1) > 40);
}

void TestGround::whoIsInANewObstacleLeavesAtAWalk()
{
    model::StageMesh mesh;
    addBox(mesh, {-30.0F, 0.0F, -30.0F}, {-29.0F, 3.0F, -29.0F});
    model::Scene scene = sceneOn(mesh);
    std::vector<glm::vec3> points;
    for (int i = 0; i < 24; ++i) {
        points.emplace_back(0.7F * static_cast<float>(i % 6) - 1.75F, 0.0F,
                            0.7F * static_cast<float>(i / 6) - 1.05F);
    }
    addPeople(scene, points);
    addPath(scene, 1, {{12.0F, 0.0F, 0.0F}}, 1.0F);
    Session session(scene);
    session.setSurface(surfaceFor(SurfacePlan::of(scene)));
    for (int step = 0; step < 15; ++step) {
        session.step();
    }
    scene.places.push_back({9, "new", {0.5F, 0.0F, 0.0F}, 2.5F, {}, model::PlaceRole::Obstacle});
    session.adopt(scene);
    session.setSurface(surfaceFor(SurfacePlan::of(scene)));
    float fastest = 0.0F;
    std::vector<glm::vec3> before;
    for (int step = 0; step < 30 * 8; ++step) {
        const auto frame = session.frame();
        const auto at = shownPositions(frame);
        for (std::size_t i = 0; i < before.size(); ++i) {
            fastest = std::max(fastest, 30.0F * glm::distance(before[i], at[i]));
        }
        before.assign(at.begin(), at.end());
        session.step();
    }
    QVERIFY2(fastest < 3.0F, qPrintable(QString::number(fastest)));
    for (const glm::vec3& at : before) {
        QVERIFY(std::hypot(at.x - 0.5F, at.z) > 2.4F);
    }
}

void TestGround::aFlowStaysWideAroundAPillar()
{
    model::StageMesh mesh;
    addBox(mesh, {-2.0F, 0.0F, -2.2F}, {2.0F, 4.0F, 2.0F});
    model::Scene scene = sceneOn(mesh);
    std::vector<glm::vec3> points;
    for (int i = 0; i < 24; ++i) {
        points.emplace_back(-14.0F - 3.0F * std::floor(static_cast<float>(i) / 3.0F), 0.0F,
                            static_cast<float>(i % 3) - 1.0F);
    }
    addPeople(scene, points);
    addPath(scene, 1, {{-12.0F, 0.0F, 0.0F}, {12.0F, 0.0F, 0.0F}}, 1.5F);
    Session session(scene);
    session.setSurface(surfaceFor(SurfacePlan::of(scene)));
    float nearest = 100.0F;
    float farthest = 0.0F;
    std::vector<float> before(points.size(), -100.0F);
    for (int step = 0; step < 30 * 60; ++step) {
        session.step();
        const auto frame = session.frame();
        const auto at = shownPositions(frame);
        for (std::size_t i = 0; i < at.size(); ++i) {
            if (before[i] < 0.0F && at[i].x >= 0.0F) {
                nearest = std::min(nearest, std::fabs(at[i].z));
                farthest = std::max(farthest, std::fabs(at[i].z));
            }
            before[i] = at[i].x;
        }
    }
    QVERIFY2(farthest - nearest > 1.5F && farthest < 7.0F,
             qPrintable(QStringLiteral("%1 to %2").arg(nearest).arg(farthest)));
}

/// Three hundred to and fro, on a path 3 m wide that passes by the middle: nearly all on one side.
void TestGround::opposingFlowsGetPastEachOtherAtAFountain()
{
    model::Scene scene;
    std::vector<glm::vec3> points;
    const auto part = [](float value) { return value - std::floor(value); };
    for (int i = 0; i < 300; ++i) {
        const auto at = static_cast<float>(i);
        points.emplace_back((i % 2 == 0 ? -1.0F : 1.0F) * (8.0F + 22.0F * part(at * 0.618F)), 0.0F,
                            1.0F + 3.0F * part(at * 0.381F) - 1.5F);
    }
    addPeople(scene, points);
    addPath(scene, 1, {{-25.0F, 0.0F, 1.0F}, {25.0F, 0.0F, 1.0F}}, 1.5F);
    scene.paths.front().kind = model::PathKind::Cyclic;
    model::Place fountain{3, "fountain", {0.0F, 0.0F, 0.0F}, 5.0F};
    fountain.role = model::PlaceRole::Obstacle;
    scene.places.push_back(fountain);
    Session session(scene);
    session.setSurface(surfaceFor(SurfacePlan::of(scene)));
    std::size_t slow = 0;
    for (int second = 0; second < 90; ++second) {
        for (int step = 0; step < 30; ++step) {
            session.step();
        }
        for (const behavior::Body& body : session.crowd().bodies()) {
            const float squared = body.velocityX * body.velocityX + body.velocityZ * body.velocityZ;
            slow += second >= 30 && squared < 0.2F * 0.2F ? 1 : 0;
        }
    }
    QVERIFY2(slow < 300 * 60 * 6 / 100, QByteArray::number(static_cast<qulonglong>(slow)));
}

void TestGround::whoeverCannotWalkAwayIsNamed()
{
    model::StageMesh mesh;
    addBox(mesh, {-5.0F, 0.0F, -5.0F}, {5.0F, 6.0F, 5.0F});
    model::Scene scene = sceneOn(mesh);
    addPeople(scene,
              {{0.0F, 6.0F, 0.0F}, {-9.0F, 0.0F, 0.0F}, {1.0F, 6.0F, 0.0F}, {2.0F, 6.0F, 0.0F}},
              {1, 1, 1, 0});
    addPath(scene, 1, {{-12.0F, 0.0F, 0.0F}}, 1.0F);
    Session session(scene);
    session.setSurface(surfaceFor(SurfacePlan::of(scene)));
    const std::vector<behavior::Problem> problems = session.problems();
    const auto named = std::ranges::find_if(
        problems, [](const behavior::Problem& problem) { return !problem.people.empty(); });
    QVERIFY(named != problems.end());
    QCOMPARE(named->people, (std::vector<model::IndividualId>{1, 3}));
    const std::string text = named->text.english();
    QVERIFY2(text.find("2 characters") != std::string::npos, text.c_str());
}

CROWD_TEST(TestGround)
#include "tst_Ground.moc"
