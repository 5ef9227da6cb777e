// SPDX-License-Identifier: MIT
#include <numeric>

#include <QtTest/QTest>

#include "model/base/Parallel.h"
#include "model/rules/RuleSets.h"
#include "tests/behavior/RuleScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;
using model::Condition;

class TestRuleActions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void waitingForAnEventEndsWithItOrInTime();
    void whoLeftComesBackWhereARuleSays();
    void leavingAtAPlaceGoesThereFirst();
    void aWalkingStyleIsKept();
    void everythingIsTheSameForAnyNumberOfThreads();
    void whatIsGoneIsSaidByName_data();
    void whatIsGoneIsSaidByName();
};

void TestRuleActions::waitingForAnEventEndsWithItOrInTime()
{
    model::Scene scene = rowOf(3);
    actions::WaitForEvent wait;
    wait.event = "now";
    wait.seconds = 2.0F;
    Rule timed = onEvent("begin", {wait, tagWith(1)});
    wait.seconds = 0.0F;
    Rule forEver = onEvent("watch", {wait, tagWith(2)});
    forEver.id = 2;
    scene.rules = {timed, forEver};
    Session session(scene);
    session.send("now", 0.0F, {1}); // before anybody waits for it
    session.send("begin", 0.0F, {1, 2});
    session.send("watch", 0.0F, {3});
    run(session, 10);
    session.send("now", 0.0F, {1});
    run(session, 2);
    QVERIFY(hasTag(session, 0, 1) && !hasTag(session, 1, 1));
    run(session, 60);
    QVERIFY(hasTag(session, 1, 1) && !hasTag(session, 2, 2));
    run(session, 300);
    QVERIFY(!hasTag(session, 2, 2));
    session.send("now", 0.0F, {3});
    run(session, 2);
    QVERIFY(hasTag(session, 2, 2));
}

void TestRuleActions::whoLeftComesBackWhereARuleSays()
{
    model::Scene scene = rowOf(2);
    scene.places = {{1, "gate", {0.0F, 0.0F, -20.0F}, 1.0F}, {2, "end", {0.0F, 0.0F, 9.0F}, 0.2F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {2}}};
    actions::Wait wait;
    wait.seconds = 2.0F;
    actions::Appear appear;
    appear.place = 1;
    actions::FollowPath follow;
    follow.path = 1;
    Rule gone = onEvent("out", {actions::LeaveScene()});
    Rule late = onEvent("late", {actions::LeaveScene(), wait, appear, follow});
    late.id = 2;
    Rule back = onEvent("back", {appear});
    back.id = 3;
    scene.rules = {gone, late, back};
    Session session(scene);
    session.send("late", 0.0F, {1});
    session.send("out", 0.0F, {2});
    run(session, 20);
    QVERIFY(placeOf(session, 0).y < -1000.0F && placeOf(session, 1).y < -1000.0F);
    run(session, 90);
    QVERIFY2(placeOf(session, 0).y == 0.0F, QByteArray::number(placeOf(session, 0).y));
    const float begun = placeOf(session, 0).z;
    QVERIFY(begun > -21.5F && begun < -10.0F);
    run(session, 90);
    QVERIFY(placeOf(session, 0).z > begun + 2.0F);
    QVERIFY(placeOf(session, 1).y < -1000.0F);
    session.send("back", 0.0F, {2});
    run(session, 3);
    QVERIFY(placeOf(session, 1).y == 0.0F && placeOf(session, 1).z < -18.0F);
}

void TestRuleActions::leavingAtAPlaceGoesThereFirst()
{
    model::Scene scene = rowOf(1);
    scene.places = {{1, "door", {0.0F, 0.0F, 5.0F}, 0.2F}};
    actions::LeaveScene leave;
    leave.place = 1;
    scene.rules = {onEvent("home", {leave})};
    Session session(scene);
    session.send("home", 0.0F, {1});
    run(session, 45);
    QVERIFY(placeOf(session, 0).z > 0.5F && placeOf(session, 0).y == 0.0F);
    run(session, 240);
    QVERIFY(placeOf(session, 0).y < -1000.0F);
}

void TestRuleActions::aWalkingStyleIsKept()
{
    model::Scene scene = rowOf(2);
    scene.places = {{1, "far", {0.0F, 0.0F, 40.0F}, 0.1F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1}}};
    letWalk(scene, 1);
    const std::vector<model::IndividualId> second{2};
    const std::vector<std::uint16_t> stroll{8}; // the eighth clip
    scene.population.setValues<std::uint16_t>(model::columns::walkStyle, second, stroll);
    Session session(scene);
    run(session, 90);
    QCOMPARE(int{clipOf(session, 0)}, 1);
    QCOMPARE(int{clipOf(session, 1)}, 7);
    const auto frame = session.frame();
    const float rate = frame->population.column(model::columns::playbackSpeed)[1];
    QVERIFY2(rate > 1.2F, QByteArray::number(rate)); // feet keep up with the ground
    const std::vector<std::uint16_t> none{0};
    scene.population.setValues<std::uint16_t>(model::columns::walkStyle, second, none);
    session.adopt(scene);
    run(session, 30);
    QCOMPARE(int{clipOf(session, 1)}, 1);
    const std::vector<std::uint16_t> wrong{99};
    scene.population.setValues<std::uint16_t>(model::columns::walkStyle, second, wrong);
    session.adopt(scene);
    run(session, 30);
    QCOMPARE(int{clipOf(session, 1)}, 1);
}

void TestRuleActions::everythingIsTheSameForAnyNumberOfThreads()
{
    model::Scene scene = rowOf(3500);
    addSeats(scene, 200);
    addLine(scene, 20);
    scene.numbers = {{1, "patience", 0.0F, 3.0F}};
    scene.rules = model::rulesOf(model::RuleSet::Queue, scene);
    actions::AddToNumber add;
    add.number = 1;
    add.value = -0.5F;
    Rule sit = when(triggers::Every{2.0F}, {add, sitDown()});
    conditions::Number low;
    low.number = 1;
    low.comparison = model::Comparison::Less;
    low.value = 0.8F;
    sit.conditions = {low};
    scene.rules.push_back(sit);
    for (std::size_t i = 0; i < scene.rules.size(); ++i) {
        scene.rules[i].id = static_cast<model::RuleId>(i + 1);
    }
    std::vector<model::Population> ends;
    for (const int threads : {1, 2, 4}) {
        const model::ThreadLimit limit(threads);
        Session session(scene);
        std::vector<model::IndividualId> some(100);
        std::iota(some.begin(), some.end(), 1U);
        session.send("queue", 0.0F, some);
        run(session, 120);
        ends.push_back(session.frame()->population);
    }
    QVERIFY(ends[0] == ends[1]);
    QVERIFY(ends[0] == ends[2]);
}

void TestRuleActions::whatIsGoneIsSaidByName_data()
{
    QTest::addColumn<Action>("lost");
    const auto row = [](const char* name, const Action& lost) { QTest::newRow(name) << lost; };
    actions::GoToPlace go;
    go.place = 77;
    row("a place to go to", go);
    row("a place to appear at", actions::Appear{77});
    actions::LeaveScene leave;
    leave.place = 77;
    row("a place to leave at", leave);
    row("a number to set", actions::SetNumber{77});
    row("a number to add to", actions::AddToNumber{77});
}

void TestRuleActions::whatIsGoneIsSaidByName()
{
    QFETCH(const Action, lost);
    model::Scene scene = rowOf(1);
    scene.rules = {onEvent("lost", {lost, tagWith(1)})};
    Session session(scene);
    session.send("lost", 0.0F, {1});
    run(session, 3);
    QCOMPARE(session.rules().problems().size(), std::size_t{1});
    QVERIFY(session.rules().problems().front().text.english().find("\"lost\"") !=
            std::string::npos);
    QVERIFY(hasTag(session, 0, 1)); // the session goes on
}

CROWD_TEST(TestRuleActions)
#include "tst_RuleActions.moc"
