// SPDX-License-Identifier: MIT
#include <cmath>
#include <set>

#include <QtTest/QTest>

#include "tests/behavior/RuleScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;

class TestRuleSeats : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void peopleSitOnTheNearestFreeSeats();
    void standingUpFreesTheSeat();
    void walkingOffFreesTheSeat();
    void whoCannotReachASeatGivesUp();
};

void TestRuleSeats::peopleSitOnTheNearestFreeSeats()
{
    model::Scene scene = rowOf(3);
    addSeats(scene, 2);
    scene.rules = {onEvent("sit", {sitDown(), tagWith(1)})};
    Session session(scene);
    session.send("sit", 0.0F, {1, 2, 3});
    run(session, 30);
    QCOMPARE(shownSeat(session, 0), model::kNoSeat); // not while he walks
    QVERIFY(placeOf(session, 0).z > 0.3F);
    run(session, 450);
    const model::SeatId first = model::SeatId{1} << 24U;
    std::set<model::SeatId> seats;
    for (std::size_t row = 0; row < 2; ++row) {
        const model::SeatId seat = shownSeat(session, row);
        QVERIFY2(seat == first || seat == first + 1, QByteArray::number(seat));
        seats.insert(seat);
        const glm::vec3 at = placeOf(session, row);
        QVERIFY(glm::distance(at, glm::vec3(0.6F * static_cast<float>(seat - first), 0.0F, 6.0F)) <
                0.01F);
        QCOMPARE(int{clipOf(session, row)}, 4); // sits
        const float heading = session.frame()->population.column(model::columns::heading)[row];
        QVERIFY2(std::abs(std::abs(heading) - 3.1416F) < 0.05F, QByteArray::number(heading));
    }
    QCOMPARE(seats.size(), std::size_t{2});
    // Too far to notice.
    scene.rules = {onEvent("sit", {actions::SitDown{2.0F}})};
    Session other(scene);
    other.send("sit", 0.0F, {1});
    run(other, 60);
    QVERIFY(placeOf(other, 0).z < 0.2F);
    // None was left for the third: on to what comes next, where he stands.
    QCOMPARE(shownSeat(session, 2), model::kNoSeat);
    QVERIFY(hasTag(session, 2, 1) && placeOf(session, 2).z < 0.2F);
    QVERIFY(scene.population.column(model::columns::seat)[0] == model::kNoSeat);
}

void TestRuleSeats::standingUpFreesTheSeat()
{
    model::Scene scene = rowOf(2);
    addSeats(scene, 1);
    const std::vector<model::IndividualId> sitter{1};
    const std::vector<model::SeatId> seat{model::SeatId{1} << 24U};
    const std::vector<glm::vec3> there{{0.0F, 0.0F, 6.0F}};
    const std::vector<std::uint16_t> clip{4};
    scene.population.setValues<model::SeatId>(model::columns::seat, sitter, seat);
    scene.population.setValues<glm::vec3>(model::columns::position, sitter, there);
    scene.population.setValues<std::uint16_t>(model::columns::clip, sitter, clip);
    Rule sit = onEvent("sit", {sitDown()});
    actions::Flee away;
    away.metres = 5.0F;
    Rule stand = onEvent("stand", {actions::StandUp(), tagWith(1), away});
    stand.id = 2;
    scene.rules = {sit, stand};
    Session session(scene);
    session.send("sit", 0.0F, {2});
    run(session, 60);
    QVERIFY(placeOf(session, 1).z < 0.2F); // taken
    session.send("stand", 0.0F, {1});
    run(session, 10);
    QCOMPARE(int{clipOf(session, 0)}, 6); // stands up
    QVERIFY(!hasTag(session, 0, 1) && shownSeat(session, 0) != model::kNoSeat);
    run(session, 30);
    QVERIFY(hasTag(session, 0, 1));
    QCOMPARE(shownSeat(session, 0), model::kNoSeat);
    run(session, 200);
    QVERIFY(glm::distance(placeOf(session, 0), there[0]) > 3.0F);
    QCOMPARE(int{clipOf(session, 0)}, 0); // and stands, though the scene has him sit
    session.send("sit", 0.0F, {2});
    run(session, 400);
    QCOMPARE(shownSeat(session, 1), seat[0]);
}

void TestRuleSeats::walkingOffFreesTheSeat()
{
    model::Scene scene = rowOf(2);
    addSeats(scene, 1);
    scene.places = {{1, "door", {0.0F, 0.0F, 12.0F}, 0.2F}};
    actions::GoToPlace go;
    go.place = 1;
    Rule sit = onEvent("sit", {sitDown()});
    Rule leave = onEvent("go", {go});
    leave.id = 2;
    scene.rules = {sit, leave};
    Session session(scene);
    session.send("sit", 0.0F, {1});
    run(session, 300);
    QVERIFY(shownSeat(session, 0) != model::kNoSeat);
    session.send("go", 0.0F, {1});
    run(session, 240);
    QCOMPARE(shownSeat(session, 0), model::kNoSeat);
    QVERIFY2(placeOf(session, 0).z > 11.0F, QByteArray::number(placeOf(session, 0).z));
    QCOMPARE(int{clipOf(session, 0)}, 0);
    // On the way to the seat the stage goes: he stands where he is, and nothing else happens.
    session.send("sit", 0.0F, {2});
    run(session, 30);
    scene.stages.clear();
    session.adopt(scene);
    run(session, 30);
    QCOMPARE(shownSeat(session, 1), model::kNoSeat);
}

void TestRuleSeats::whoCannotReachASeatGivesUp()
{
    model::Scene scene = rowOf(1);
    addSeats(scene, 1);
    // Shut in by obstacles all around.
    for (int i = 0; i < 12; ++i) {
        const float angle = static_cast<float>(i) * 0.5235988F;
        scene.places.push_back({static_cast<model::PlaceId>(i + 1),
                                "pillar",
                                {1.2F * std::sin(angle), 0.0F, 1.2F * std::cos(angle)},
                                0.4F,
                                {},
                                model::PlaceRole::Obstacle});
    }
    scene.rules = {onEvent("sit", {sitDown(), tagWith(1)})};
    Session session(scene);
    session.send("sit", 0.0F, {1});
    run(session, 700);
    QVERIFY(hasTag(session, 0, 1));
    QCOMPARE(shownSeat(session, 0), model::kNoSeat);
    QVERIFY(glm::length(placeOf(session, 0)) < 1.3F);
}

CROWD_TEST(TestRuleSeats)
#include "tst_RuleSeats.moc"
