// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "behavior/surface/WalkSurface.h"
#include "tests/behavior/BoxStage.h"
#include "tests/behavior/RuleScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;
using model::PlaceChoice;
using model::PlaceRole;

namespace {

Action goTo(model::PlaceId place)
{
    actions::GoToPlace go;
    go.place = place;
    return go;
}

Action leaveAt(PlaceChoice choice, model::PlaceId place = 0, model::PathId path = 0)
{
    actions::LeaveScene leave;
    leave.choice = choice;
    leave.place = place;
    leave.path = path;
    return leave;
}

bool isGone(const Session& session, std::size_t row)
{
    return placeOf(session, row).y < -1000.0F;
}

/// How near somebody gets to a point before he has left, or within so many steps.
float nearestTo(Session& session, std::size_t row, const glm::vec3& point, int steps)
{
    float nearest = 1e9F;
    for (int i = 0; i < steps && !isGone(session, row); ++i) {
        nearest = std::min(nearest, behavior::flatDistance(placeOf(session, row), point));
        session.step();
    }
    return nearest;
}

/// A wall along Z at x = 4.
model::StageEntry wallBeside(float low, float high)
{
    model::StageMesh mesh;
    addBox(mesh, {4.0F, 0.0F, low}, {4.5F, 3.0F, high});
    return stageOf(mesh);
}

void letPeopleStandOn(Session& session, const model::Scene& scene)
{
    const auto surface = surfaceOf(scene);
    QVERIFY(surface);
    session.setSurface(surface);
}

} // namespace

/// Rules that send people from one place to the next, and out.
class TestRuleWalks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void walksFollowEachOther();
    void goingToSomebodyAfterAWalkIsWalked();
    void everyPlaceOnTheWayIsNoticed();
    void whoLeavesTakesTheExitThatIsMeant_data();
    void whoLeavesTakesTheExitThatIsMeant();
    void whoHasNowhereToLeaveAtStays_data();
    void whoHasNowhereToLeaveAtStays();
    void exitsAreTakenByNoMoreThanHaveRoom();
    void whoseExitIsTakenAwayTakesAnotherOne();
    void theNearestExitIsThatWithTheShortestWay();
    void whoWasStoppedByAWallGoesWhereHeIsSentNext();
    void whoRunsToAnExitGetsOut();
};

void TestRuleWalks::walksFollowEachOther()
{
    model::Scene scene = rowOf(1);
    scene.places = {{1, "a", {0.0F, 0.0F, 6.0F}, 0.2F}, {2, "b", {8.0F, 0.0F, 6.0F}, 0.2F}};
    scene.rules = {onEvent("go", {goTo(1), goTo(2), actions::LeaveScene()})};
    Session session(scene);
    session.send("go", 0.0F, {1});
    run(session, 300);
    QVERIFY(!isGone(session, 0)); // 6 m are walked by now, 14 m are not
    const float nearest = nearestTo(session, 0, scene.places[1].position, 900);
    QVERIFY2(nearest < 1.0F, QByteArray::number(static_cast<double>(nearest)));
    QVERIFY(isGone(session, 0));
}

void TestRuleWalks::goingToSomebodyAfterAWalkIsWalked()
{
    model::Scene scene = rowOf(6); // the last one at x = 10
    scene.places = {{1, "a", {0.0F, 0.0F, 6.0F}, 0.2F}};
    actions::GoToPerson meet;
    meet.aim = model::ActionAim::Tagged;
    meet.tag = 4;
    meet.metres = 1.5F;
    meet.seconds = 0.0F;
    scene.population.setValues<std::uint64_t>(model::columns::tags,
                                              std::vector<model::IndividualId>{6},
                                              std::vector<std::uint64_t>{std::uint64_t{1} << 4U});
    scene.rules = {onEvent("go", {goTo(1), meet, tagWith(1)})};
    Session session(scene);
    session.send("go", 0.0F, {1});
    run(session, 900);
    QVERIFY(hasTag(session, 0, 1));
    const float away = behavior::flatDistance(placeOf(session, 0), placeOf(session, 5));
    QVERIFY2(away < 2.5F, QByteArray::number(static_cast<double>(away)));
}

void TestRuleWalks::everyPlaceOnTheWayIsNoticed()
{
    model::Scene scene = rowOf(1);
    scene.places = {{1, "a", {0.0F, 0.0F, 6.0F}, 0.2F}, {2, "b", {6.0F, 0.0F, 6.0F}, 0.2F}};
    scene.rules = {onEvent("go", {goTo(1), goTo(2)})};
    for (const model::PlaceId place : {1U, 2U}) {
        Rule seen = when(triggers::Arrived{place}, {tagWith(static_cast<std::uint8_t>(place))});
        seen.meeting = model::RuleMeeting::Queue;
        seen.id = 1 + place;
        scene.rules.push_back(seen);
    }
    Session session(scene);
    session.send("go", 0.0F, {1});
    run(session, 900);
    QVERIFY(hasTag(session, 0, 1));
    QVERIFY(hasTag(session, 0, 2));
    QCOMPARE(session.rules().count(2), std::uint64_t{1});
    QCOMPARE(session.rules().count(3), std::uint64_t{1});
}

void TestRuleWalks::whoLeavesTakesTheExitThatIsMeant_data()
{
    QTest::addColumn<int>("choice");
    QTest::addColumn<model::PlaceId>("place");
    QTest::addColumn<model::PathId>("path");
    QTest::addColumn<std::size_t>("at");
    const auto row = [](const char* name, PlaceChoice choice, model::PlaceId place,
                        model::PathId path, std::size_t at) {
        QTest::newRow(name) << static_cast<int>(choice) << place << path << at;
    };
    row("the one that is named", PlaceChoice::Given, 1, 0, 0);
    row("the nearest exit, no spot", PlaceChoice::Nearest, 0, 0, 1);
    row("the nearest of that name", PlaceChoice::Nearest, 3, 0, 2);
    row("the nearest of a path", PlaceChoice::Nearest, 0, 1, 3);
    row("the nearest free exit", PlaceChoice::NearestFree, 0, 0, 1);
    row("the first free one of a path", PlaceChoice::FirstFree, 0, 1, 4);
}

void TestRuleWalks::whoLeavesTakesTheExitThatIsMeant()
{
    QFETCH(const int, choice);
    QFETCH(const model::PlaceId, place);
    QFETCH(const model::PathId, path);
    QFETCH(const std::size_t, at);
    model::Scene scene = rowOf(1);
    scene.places = {{1, "gate", {0.0F, 0.0F, 12.0F}, 0.5F},
                    {2, "side", {-6.0F, 0.0F, 0.0F}, 0.5F},
                    {3, "spot", {0.0F, 0.0F, -4.0F}, 0.5F},
                    {4, "near", {5.0F, 0.0F, 5.0F}, 0.5F},
                    {5, "far", {12.0F, 0.0F, -5.0F}, 0.5F}};
    scene.places[0].role = PlaceRole::Exit;
    scene.places[1].role = PlaceRole::Exit;
    scene.paths = {{1, "way", model::PathKind::Simple, {5, 4}}};
    scene.rules = {onEvent("home", {leaveAt(static_cast<PlaceChoice>(choice), place, path)})};
    Session session(scene);
    session.send("home", 0.0F, {1});
    const float nearest = nearestTo(session, 0, scene.places[at].position, 900);
    QVERIFY2(nearest < 1.2F, QByteArray::number(static_cast<double>(nearest)));
    QVERIFY(isGone(session, 0));
}

void TestRuleWalks::whoHasNowhereToLeaveAtStays_data()
{
    QTest::addColumn<int>("choice");
    QTest::addColumn<model::PlaceId>("place");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("a place that is gone")
        << static_cast<int>(PlaceChoice::Given) << model::PlaceId{9} << QByteArray("not there");
    QTest::newRow("no exit") << static_cast<int>(PlaceChoice::Nearest) << model::PlaceId{0}
                             << QByteArray("at an exit, but there is none");
}

void TestRuleWalks::whoHasNowhereToLeaveAtStays()
{
    QFETCH(const int, choice);
    QFETCH(const model::PlaceId, place);
    QFETCH(const QByteArray, said);
    model::Scene scene = rowOf(1);
    scene.rules = {onEvent("home", {leaveAt(static_cast<PlaceChoice>(choice), place), tagWith(1)})};
    Session session(scene);
    session.send("home", 0.0F, {1});
    run(session, 60);
    QVERIFY(!isGone(session, 0));
    QVERIFY(hasTag(session, 0, 1)); // on with the next
    QCOMPARE(session.problems().size(), std::size_t{1});
    QVERIFY2(session.problems().front().text.english().find(said.constData()) != std::string::npos,
             session.problems().front().text.english().c_str());
}

void TestRuleWalks::exitsAreTakenByNoMoreThanHaveRoom()
{
    model::Scene scene = rowOf(4);
    scene.places = {{1, "near", {3.0F, 0.0F, 6.0F}, 0.3F}, {2, "far", {3.0F, 0.0F, 30.0F}, 0.3F}};
    for (model::Place& place : scene.places) {
        place.role = PlaceRole::Exit;
        place.capacity = 2;
    }
    scene.rules = {onEvent("home", {leaveAt(PlaceChoice::NearestFree)})};
    Session session(scene);
    session.send("home", 0.0F, {1, 2, 3, 4});
    run(session, 400);
    std::size_t gone = 0;
    for (std::size_t row = 0; row < 4; ++row) {
        gone += isGone(session, row) ? 1 : 0;
    }
    QCOMPARE(gone, std::size_t{2});
    run(session, 900);
    for (std::size_t row = 0; row < 4; ++row) {
        QVERIFY(isGone(session, row));
    }
}

/// On the way to it; without any other he stays.
void TestRuleWalks::whoseExitIsTakenAwayTakesAnotherOne()
{
    for (const bool isAnotherThere : {true, false}) {
        model::Scene scene = rowOf(1);
        scene.places = {{1, "near", {0.0F, 0.0F, 9.0F}, 0.3F},
                        {2, "far", {0.0F, 0.0F, 20.0F}, 0.3F}};
        for (model::Place& place : scene.places) {
            place.role = PlaceRole::Exit;
        }
        scene.rules = {onEvent("home", {leaveAt(PlaceChoice::Nearest), tagWith(1)})};
        Session session(scene);
        session.send("home", 0.0F, {1});
        run(session, 120);
        QVERIFY(placeOf(session, 0).z > 0.5F);
        scene.places.erase(scene.places.begin());
        if (!isAnotherThere) {
            scene.places.clear();
        }
        session.adopt(scene);
        run(session, 1500);
        QCOMPARE(isGone(session, 0), isAnotherThere);
        QVERIFY(hasTag(session, 0, 1)); // on with the next
        QCOMPARE(session.problems().size(), std::size_t{isAnotherThere ? 0U : 1U});
    }
}

void TestRuleWalks::theNearestExitIsThatWithTheShortestWay()
{
    model::Scene scene = rowOf(1);
    scene.stages = {wallBeside(-30.0F, 30.0F)};
    scene.places = {{1, "behind the wall", {7.0F, 0.0F, 0.0F}, 0.5F},
                    {2, "down the street", {-14.0F, 0.0F, 0.0F}, 0.5F}};
    for (model::Place& place : scene.places) {
        place.role = PlaceRole::Exit;
    }
    scene.rules = {onEvent("home", {leaveAt(PlaceChoice::Nearest)})};
    Session session(scene);
    letPeopleStandOn(session, scene);
    session.send("home", 0.0F, {1});
    const float nearest = nearestTo(session, 0, scene.places[1].position, 900);
    QVERIFY2(nearest < 1.2F, QByteArray::number(static_cast<double>(nearest)));
    QVERIFY(isGone(session, 0));
}

/// The end of the way that led nowhere is not that of the next one.
void TestRuleWalks::whoWasStoppedByAWallGoesWhereHeIsSentNext()
{
    model::Scene scene = rowOf(1);
    model::StageMesh house;
    addBox(house, {4.0F, 0.0F, -6.0F}, {16.0F, 8.0F, 6.0F});
    scene.stages = {stageOf(house)};
    scene.places = {{1, "in the house", {10.0F, 0.0F, 0.0F}, 0.3F},
                    {2, "beside it", {0.0F, 0.0F, 12.0F}, 0.3F}};
    scene.rules = {onEvent("go", {goTo(1), goTo(2), tagWith(1)})};
    Session session(scene);
    letPeopleStandOn(session, scene);
    session.send("go", 0.0F, {1});
    run(session, 900);
    QVERIFY(hasTag(session, 0, 1));
    const float away = behavior::flatDistance(placeOf(session, 0), scene.places[1].position);
    QVERIFY2(away < 1.0F, QByteArray::number(static_cast<double>(away)));
}

/// He begins to slow down before he is in it.
void TestRuleWalks::whoRunsToAnExitGetsOut()
{
    for (const float speed : {1.3F, 3.0F, 6.0F}) {
        model::Scene scene = rowOf(1);
        scene.places = {{1, "exit", {0.0F, 0.0F, 30.0F}, 0.3F}};
        scene.places[0].role = PlaceRole::Exit;
        actions::SetSpeed pace;
        pace.value = speed;
        scene.rules = {onEvent("home", {pace, leaveAt(PlaceChoice::Nearest)})};
        Session session(scene);
        session.send("home", 0.0F, {1});
        const float nearest = nearestTo(session, 0, scene.places[0].position, 900);
        QVERIFY(isGone(session, 0));
        QVERIFY2(nearest < 2.1F, QByteArray::number(static_cast<double>(nearest)));
        QVERIFY(session.problems().empty());
    }
}

CROWD_TEST(TestRuleWalks)
#include "tst_RuleWalks.moc"
