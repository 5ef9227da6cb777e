// SPDX-License-Identifier: MIT
#include <limits>

#include <QtTest/QTest>

#include "tests/behavior/RuleScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;
using model::Condition;

class TestRuleTriggers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void thePayloadCanBeAskedFor();
    void aSpeedLimitIsNoticedOnceEachTime();
    void standingTooLongIsNoticedOnce();
    void aRuleYieldsAsItSays_data();
    void aRuleYieldsAsItSays();
    void whoArrivesIsFreeForTheRuleThatWaitsForIt();
};

void TestRuleTriggers::thePayloadCanBeAskedFor()
{
    model::Scene scene = rowOf(2);
    Rule loud = onEvent("bang", {tagWith(1)});
    conditions::Payload above;
    above.value = 5.0F;
    loud.conditions = {above};
    scene.rules = {loud};
    Session session(scene);
    session.send("bang", 4.0F, {1});
    session.send("bang", 6.0F, {2});
    session.send("bang", std::numeric_limits<float>::quiet_NaN(), {1});
    run(session, 2);
    QVERIFY(!hasTag(session, 0, 1) && hasTag(session, 1, 1));
}

void TestRuleTriggers::aSpeedLimitIsNoticedOnceEachTime()
{
    model::Scene scene = rowOf(1);
    scene.places = {{1, "far", {0.0F, 0.0F, 80.0F}, 0.1F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1}}};
    letWalk(scene, 1);
    Rule fast = when(triggers::SpeedLimit{true, 2.0F}, {tagWith(1)});
    Rule slow = when(triggers::SpeedLimit{false, 0.5F}, {tagWith(2)}, 2);
    actions::SetSpeed speed;
    Rule set = onEvent("speed", {speed});
    set.id = 3;
    Rule stop = onEvent("stop", {actions::Stop()});
    stop.id = 4;
    scene.rules = {set, stop, fast, slow};
    Session session(scene);
    run(session, 90);
    QVERIFY(!hasTag(session, 0, 1) && !hasTag(session, 0, 2)); // standing at first is no event
    session.send("speed", 3.0F, {1});
    run(session, 90);
    QVERIFY(hasTag(session, 0, 1));
    QCOMPARE(session.rules().count(1), std::uint64_t{1});
    session.send("stop", 0.0F, {1});
    run(session, 120);
    QCOMPARE(session.rules().count(1), std::uint64_t{1});
    QCOMPARE(session.rules().count(2), std::uint64_t{1});
}

void TestRuleTriggers::standingTooLongIsNoticedOnce()
{
    model::Scene scene = rowOf(1);
    scene.places = {{1, "there", {0.0F, 0.0F, 5.0F}, 0.1F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1}}};
    letWalk(scene, 1);
    Rule bored = when(triggers::Waited{3.0F}, {tagWith(1)});
    scene.rules = {bored};
    Session session(scene);
    run(session, 150); // he has just arrived
    QCOMPARE(session.rules().count(1), std::uint64_t{0});
    run(session, 240);
    QCOMPARE(session.rules().count(1), std::uint64_t{1});
    run(session, 240);
    QCOMPARE(session.rules().count(1), std::uint64_t{1});
}

void TestRuleTriggers::aRuleYieldsAsItSays_data()
{
    QTest::addColumn<int>("yields");
    QTest::addColumn<bool>("isBrokenByAbove");
    QTest::addColumn<bool>("isBrokenByBelow");
    QTest::newRow("to those further up")
        << static_cast<int>(model::RuleYield::FurtherUp) << true << false;
    QTest::newRow("to anybody") << static_cast<int>(model::RuleYield::Anybody) << true << true;
    QTest::newRow("to nobody") << static_cast<int>(model::RuleYield::Nobody) << false << false;
    QTest::newRow("to others further up")
        << static_cast<int>(model::RuleYield::Others) << true << false;
}

void TestRuleTriggers::aRuleYieldsAsItSays()
{
    QFETCH(const int, yields);
    QFETCH(const bool, isBrokenByAbove);
    QFETCH(const bool, isBrokenByBelow);
    for (const bool isAbove : {true, false}) {
        model::Scene scene = rowOf(1);
        actions::Wait wait;
        wait.seconds = 60.0F;
        Rule busy = onEvent("work", {wait});
        busy.yields = static_cast<model::RuleYield>(yields);
        Rule other = onEvent("call", {tagWith(1)});
        other.id = 2;
        scene.rules = isAbove ? std::vector<Rule>{other, busy} : std::vector<Rule>{busy, other};
        Session session(scene);
        session.send("work", 0.0F, {1});
        run(session, 3);
        session.send("call", 0.0F, {1});
        run(session, 3);
        QCOMPARE(hasTag(session, 0, 1), isAbove ? isBrokenByAbove : isBrokenByBelow);
    }
}

void TestRuleTriggers::whoArrivesIsFreeForTheRuleThatWaitsForIt()
{
    model::Scene scene = rowOf(1);
    scene.places = {{1, "desk", {0.0F, 0.0F, 5.0F}, 0.3F}};
    actions::GoToPlace go;
    go.place = 1;
    Rule arrived = when(triggers::Arrived{1}, {tagWith(3)}, 2);
    arrived.meeting = model::RuleMeeting::Ignore;
    scene.rules = {onEvent("go", {go}), arrived};
    Session session(scene);
    session.send("go", 0.0F, {1});
    run(session, 60);
    QVERIFY(!hasTag(session, 0, 3));
    run(session, 180);
    QVERIFY(hasTag(session, 0, 3));
    QCOMPARE(session.rules().count(2), std::uint64_t{1});
}

CROWD_TEST(TestRuleTriggers)
#include "tst_RuleTriggers.moc"
