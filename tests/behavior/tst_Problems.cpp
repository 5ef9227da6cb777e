// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "behavior/surface/WalkSurface.h"
#include "tests/behavior/Actors.h"
#include "tests/behavior/BoxStage.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;
using behavior::Problem;
using behavior::WalkSurface;

namespace {

/// A wall 20 m long along X, 1 m thick; one around a yard of 8 m, where `isClosed`.
model::StageEntry walls(bool isClosed)
{
    model::StageMesh mesh;
    if (isClosed) {
        addBox(mesh, {-5.0F, 0.0F, 4.0F}, {5.0F, 3.0F, 5.0F});
        addBox(mesh, {-5.0F, 0.0F, -5.0F}, {5.0F, 3.0F, -4.0F});
        addBox(mesh, {4.0F, 0.0F, -4.0F}, {5.0F, 3.0F, 4.0F});
        addBox(mesh, {-5.0F, 0.0F, -4.0F}, {-4.0F, 3.0F, 4.0F});
    } else {
        addBox(mesh, {-10.0F, 0.0F, -0.5F}, {10.0F, 3.0F, 0.5F});
    }
    return stageOf(mesh);
}

/// People in a row at z = 6, a path "way" between two places.
model::Scene walledScene(bool isClosed, const glm::vec3& from, const glm::vec3& to)
{
    model::Scene scene = rowOf(3);
    scene.stages.push_back(walls(isClosed));
    scene.places = {{1, "here", from, 0.5F}, {2, "there", to, 0.5F}};
    scene.paths = {{7, "way", model::PathKind::Simple, {1, 2}}};
    return scene;
}

bool isSaid(const std::vector<Problem>& problems, const char* words, const Problem& about)
{
    return std::ranges::any_of(problems, [&](const Problem& problem) {
        return problem.text.english().find(words) != std::string::npos &&
               problem.rule == about.rule && problem.place == about.place &&
               problem.path == about.path;
    });
}

Problem ofPath(model::PathId path)
{
    return {{}, 0, 0, path};
}

Problem ofPlace(model::PlaceId place)
{
    return {{}, 0, place};
}

Problem ofRule(model::RuleId rule)
{
    return {{}, rule};
}

} // namespace

class TestProblems : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aPathThroughAWallIsSaid();
    void aPathThatNobodyCanWalkIsSaid();
    void aPathInTheOpenIsNot();
    void aPlaceOffTheGroundIsSaid_data();
    void aPlaceOffTheGroundIsSaid();
    void aRuleWithADeletedPathIsSaid();
    void eventsThatGoRoundAreSaid();
    void eventsThatAreSprayedAreNot();
    void tooManyForAPlaceAreSaid_data();
    void tooManyForAPlaceAreSaid();
    void stepsWithoutTimeAreTheUsualOnes();
    void whoHasNoPositionIsLeftOut();
    void numbersOfEventsAreFinite();
};

void TestProblems::aPathThroughAWallIsSaid()
{
    const model::Scene scene = walledScene(false, {0.0F, 0.0F, 5.0F}, {0.0F, 0.0F, -5.0F});
    Session session(scene);
    session.setSurface(surfaceOf(scene));
    QCOMPARE(session.warnings().size(), std::size_t{1});
    QVERIFY(isSaid(session.warnings(), "between \"here\" and \"there\" something is in the way",
                   ofPath(7)));
    run(session, 30);
    QCOMPARE(session.warnings().size(), std::size_t{1});
    // Nor once the wall is gone, and again when it is back.
    session.setSurface(nullptr);
    QVERIFY(session.warnings().empty());
    session.setSurface(surfaceOf(scene));
    QCOMPARE(session.warnings().size(), std::size_t{1});
    // It is said no more once the path leads around.
    model::Scene mended = scene;
    mended.places.push_back({3, "corner", {12.0F, 0.0F, 3.0F}, 0.5F});
    mended.places.push_back({4, "other corner", {12.0F, 0.0F, -3.0F}, 0.5F});
    mended.paths[0].places = {1, 3, 4, 2};
    session.adopt(mended);
    QVERIFY(session.warnings().empty());
}

void TestProblems::aPathThatNobodyCanWalkIsSaid()
{
    const model::Scene scene = walledScene(true, {0.0F, 0.0F, 8.0F}, {0.0F, 0.0F, 0.0F});
    Session session(scene);
    session.setSurface(surfaceOf(scene));
    QVERIFY(isSaid(session.warnings(), "no way leads", ofPath(7)));
}

void TestProblems::aPathInTheOpenIsNot()
{
    const model::Scene scene = walledScene(false, {-6.0F, 0.0F, 5.0F}, {6.0F, 0.0F, 4.0F});
    Session session(scene);
    session.setSurface(surfaceOf(scene));
    QVERIFY(session.warnings().empty());
}

void TestProblems::aPlaceOffTheGroundIsSaid_data()
{
    QTest::addColumn<glm::vec3>("place");
    QTest::newRow("in the air") << glm::vec3(6.0F, 9.0F, 5.0F);
    QTest::newRow("in a wall") << glm::vec3(0.0F, 0.0F, 0.0F);
}

void TestProblems::aPlaceOffTheGroundIsSaid()
{
    QFETCH(const glm::vec3, place);
    const model::Scene scene = walledScene(false, {0.0F, 0.0F, 5.0F}, place);
    Session session(scene);
    session.setSurface(surfaceOf(scene));
    QVERIFY(isSaid(session.warnings(), "\"there\" is not on ground", ofPlace(2)));
    run(session, 30);
}

void TestProblems::aRuleWithADeletedPathIsSaid()
{
    model::Scene scene = rowOf(1);
    scene.places = {{1, "end", {0.0F, 0.0F, 30.0F}, 0.1F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1}}};
    const std::vector<model::IndividualId> ids{1};
    const std::vector<model::PathId> paths{1};
    scene.population.setValues<model::PathId>(model::columns::path, ids, paths);
    actions::FollowPath walk;
    walk.path = 12;
    scene.rules = {onEvent("go", {walk})};
    scene.rules[0].id = 5;
    Session session(scene);
    run(session, 30);
    session.send("go", 0.0F, {1});
    run(session, 2);
    QVERIFY(isSaid(session.rules().problems(), "a path that is not there any more", ofRule(5)));
    run(session, 120);
    QVERIFY(placeOf(session, 0).z > 4.0F); // goes on where he was going
}

void TestProblems::eventsThatGoRoundAreSaid()
{
    model::Scene scene = rowOf(3);
    Rule ping = onEvent("ping", {tellNear("pong", 3.0F)});
    ping.id = 3;
    Rule pong = onEvent("pong", {tellNear("ping", 3.0F)});
    pong.id = 4;
    scene.rules = {ping, pong};
    Session session(scene);
    session.send("ping", 0.0F, {1});
    run(session, 10);
    QVERIFY(session.rules().problems().empty());
    run(session, 110);
    QVERIFY(isSaid(session.rules().problems(), "events go round in a circle", ofRule(3)));
    QCOMPARE(session.steps(), std::uint64_t{120});
    // A pause ends it.
    scene.rules[0].cooldownSeconds = 1.0F;
    session.adopt(scene);
    run(session, 120);
    QVERIFY(session.rules().problems().empty());
}

void TestProblems::eventsThatAreSprayedAreNot()
{
    model::Scene scene = rowOf(1);
    scene.rules = {onEvent("go", {actions::Stop()})};
    Session session(scene);
    for (int i = 0; i < 100; ++i) {
        session.send("go", 0.0F, {1});
        session.step();
    }
    QCOMPARE(session.rules().count(1), std::uint64_t{100});
    QVERIFY(session.rules().problems().empty());
}

void TestProblems::tooManyForAPlaceAreSaid_data()
{
    QTest::addColumn<bool>("isPath");
    QTest::newRow("sent there by a rule") << false;
    QTest::newRow("at the end of a path") << true;
}

void TestProblems::tooManyForAPlaceAreSaid()
{
    QFETCH(const bool, isPath);
    const std::size_t people = isPath ? 400 : 10'000;
    model::Scene scene = rowOf(people);
    // On a square, half a metre apart.
    const auto ids = scene.population.ids();
    const std::vector<model::IndividualId> all(ids.begin(), ids.end());
    std::vector<glm::vec3> positions;
    const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(people)));
    for (std::size_t i = 0; i < people; ++i) {
        positions.emplace_back(0.6F * static_cast<float>(i % side), 0.0F,
                               0.6F * static_cast<float>(i / side));
    }
    scene.population.setValues<glm::vec3>(model::columns::position, all, positions);
    scene.places = {{4, "gate", {6.0F, 0.0F, 6.0F}, 1.0F}};
    scene.paths = {{1, "in", model::PathKind::Simple, {4}}};
    if (isPath) {
        const std::vector<model::PathId> paths(people, 1);
        scene.population.setValues<model::PathId>(model::columns::path, all, paths);
    }
    actions::GoToPlace go;
    go.place = 4;
    scene.rules = {onEvent("go", {go})};
    Session session(scene);
    if (!isPath) {
        session.send("go", 0.0F, all);
    }
    const int steps = isPath ? 900 : 31;
    for (int i = 0; i < steps && session.warnings().empty(); ++i) {
        session.step();
    }
    QCOMPARE(session.warnings().size(), std::size_t{1});
    QVERIFY(isSaid(session.warnings(), "characters want to stand there; there is room for 6",
                   ofPlace(4)));
    run(session, 2); // and on
    const auto frame = session.frame();
    for (const glm::vec3& position : frame->population.column(model::columns::position)) {
        QVERIFY(std::isfinite(position.x) && std::isfinite(position.z));
    }
}

void TestProblems::stepsWithoutTimeAreTheUsualOnes()
{
    model::Scene scene = rowOf(1);
    scene.stepsPerSecond = 0;
    Session session(scene);
    run(session, 30);
    QCOMPARE(session.seconds(), 1.0);
    QVERIFY(isSaid(session.warnings(), "0 steps a second", {}));
}

void TestProblems::whoHasNoPositionIsLeftOut()
{
    model::Scene scene = rowOf(20);
    scene.places = {{1, "there", {5.0F, 0.0F, 9.0F}, 1.0F}};
    scene.paths = {{1, "in", model::PathKind::Simple, {1}}};
    const auto ids = scene.population.ids();
    const std::vector<model::IndividualId> all(ids.begin(), ids.end());
    scene.population.setValues<model::PathId>(model::columns::path, all,
                                              std::vector<model::PathId>(20, 1));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    scene.population.setValues<glm::vec3>(model::columns::position,
                                          std::vector<model::IndividualId>{7},
                                          std::vector<glm::vec3>{{nan, 0.0F, nan}});
    Session session(scene);
    QVERIFY(isSaid(session.warnings(), "left out: 1.", {}));
    run(session, 120);
    for (std::size_t row = 0; row < 20; ++row) {
        const glm::vec3 at = placeOf(session, row);
        QVERIFY(std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z));
        QVERIFY(row == 6 || at.z > 1.0F);
    }
}

void TestProblems::numbersOfEventsAreFinite()
{
    model::Scene scene = rowOf(1);
    actions::SetSpeed speed;
    speed.value = 0.0F; // the event's
    scene.rules = {onEvent("go", {speed})};
    Session session(scene);
    session.send("go", std::numeric_limits<float>::quiet_NaN(), {1});
    run(session, 2);
    QCOMPARE(session.rules().count(1), std::uint64_t{0});
    QVERIFY(isSaid(session.warnings(), "Event \"go\" came with a number that is none", {}));
}

CROWD_TEST(TestProblems)
#include "tst_Problems.moc"
