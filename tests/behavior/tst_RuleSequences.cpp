// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "model/base/Parallel.h"
#include "tests/behavior/Actors.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

constexpr model::NumberId kCount = 1;

Action deeper(Action action, int depth)
{
    action.depth = static_cast<std::uint8_t>(depth);
    return action;
}

Action add(float value, int depth = 0, model::NumberId number = kCount)
{
    actions::AddToNumber made;
    made.number = number;
    made.value = value;
    return deeper(made, depth);
}

Action pause(float seconds, int depth = 0)
{
    actions::Wait made;
    made.seconds = seconds;
    return deeper(made, depth);
}

Action repeat(std::uint32_t times, int depth = 0)
{
    actions::Repeat made;
    made.times = times;
    return deeper(made, depth);
}

Action oneOf(float weight, int depth = 0)
{
    actions::OneOf made;
    made.weight = weight;
    return deeper(made, depth);
}

/// Everybody counts; "go" has reached all of them and so many steps have passed.
model::Scene sceneWith(std::size_t people, std::vector<Action> actions)
{
    model::Scene scene = rowOf(people);
    scene.numbers = {{kCount, "count", 0.0F, 0.0F}, {2, "second", 0.0F, 0.0F}};
    scene.rules = {onEvent("go", std::move(actions))};
    return scene;
}

void go(Session& session, std::size_t people)
{
    std::vector<model::IndividualId> ids(people);
    std::iota(ids.begin(), ids.end(), 1U);
    session.send("go", 0.0F, ids);
}

} // namespace

class TestRuleSequences : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aPartRepeatsSoManyTimes_data();
    void aPartRepeatsSoManyTimes();
    void forEverIsUntilAnotherRuleComes();
    void withoutTimeForEverIsEnded();
    void oneOfSeveralComesByItsWeight();
    void eachRoundIsDrawnAnew();
    void thingsHappenToTheStep();
    void isTheSameForAnyNumberOfThreads();
};

void TestRuleSequences::aPartRepeatsSoManyTimes_data()
{
    QTest::addColumn<std::vector<Action>>("actions");
    QTest::addColumn<float>("count");
    using List = std::vector<Action>;
    QTest::newRow("three times") << List{repeat(3), add(1, 1), add(10)} << 13.0F;
    QTest::newRow("one within the other")
        << List{repeat(3), add(1, 1), repeat(4, 1), add(100, 2), add(1000)} << 2203.0F;
    QTest::newRow("the inner one first")
        << List{repeat(2), repeat(5, 1), add(1, 2), add(100, 1)} << 210.0F;
    QTest::newRow("nothing in it") << List{repeat(3), add(1)} << 1.0F;
    QTest::newRow("nothing behind it") << List{add(1), repeat(7), add(2, 1)} << 15.0F;
    QTest::newRow("a choice in it")
        << List{repeat(5), oneOf(1, 1), add(1, 2), oneOf(0, 1), add(100, 2), add(1000)} << 1005.0F;
    QTest::newRow("in a choice") << List{oneOf(0),     add(100, 1), oneOf(1),
                                         repeat(4, 1), add(1, 2),   add(1000)}
                                 << 1004.0F;
    QTest::newRow("nothing in what is chosen")
        << List{oneOf(1), oneOf(0), add(100, 1), add(1)} << 1.0F;
}

void TestRuleSequences::aPartRepeatsSoManyTimes()
{
    QFETCH(const std::vector<Action>, actions);
    QFETCH(const float, count);
    Session session(sceneWith(1, actions));
    go(session, 1);
    run(session, 3);
    QCOMPARE(session.rules().number(0, kCount), count);
    QVERIFY(session.rules().problems().empty());
}

void TestRuleSequences::forEverIsUntilAnotherRuleComes()
{
    model::Scene scene = sceneWith(1, {repeat(0), add(1, 1), pause(0.2F, 1), add(1000)});
    Rule stop = onEvent("stop", {add(1, 0, 2)});
    stop.id = 2;
    scene.rules.insert(scene.rules.begin(), stop);
    Session session(scene);
    go(session, 1);
    run(session, 300); // ten seconds, each round 0.1 to 0.3 s and a step
    const float count = session.rules().number(0, kCount);
    QVERIFY2(count > 30.0F && count < 90.0F, QByteArray::number(static_cast<double>(count)));
    session.send("stop", 0.0F, {1});
    run(session, 2);
    const float stopped = session.rules().number(0, kCount);
    run(session, 60);
    QCOMPARE(session.rules().number(0, kCount), stopped);
    QCOMPARE(session.rules().number(0, 2), 1.0F);
}

void TestRuleSequences::withoutTimeForEverIsEnded()
{
    Session session(sceneWith(2, {repeat(0), add(1, 1), add(1000)}));
    session.send("go", 0.0F, {2});
    run(session, 5);
    QCOMPARE(session.rules().problems().size(), std::size_t{1});
    QVERIFY(session.rules().problems().front().text.english().find("\"go\" repeats without") !=
            std::string::npos);
    QVERIFY(session.rules().number(1, kCount) < 2000.0F);
    QCOMPARE(session.steps(), std::uint64_t{5});
}

void TestRuleSequences::oneOfSeveralComesByItsWeight()
{
    constexpr std::size_t kPeople = 2000;
    Session session(sceneWith(
        kPeople, {oneOf(6), add(1, 1), oneOf(3), add(2, 1), oneOf(1), add(3, 1), add(1, 0, 2)}));
    go(session, kPeople);
    run(session, 3);
    std::array<int, 4> drawn{};
    for (std::uint32_t agent = 0; agent < kPeople; ++agent) {
        ++drawn[static_cast<std::size_t>(session.rules().number(agent, kCount))];
        QCOMPARE(session.rules().number(agent, 2), 1.0F); // and on
    }
    QCOMPARE(drawn[0], 0);
    QVERIFY2(std::abs(drawn[1] - 1200) < 90, QByteArray::number(drawn[1]));
    QVERIFY2(std::abs(drawn[2] - 600) < 80, QByteArray::number(drawn[2]));
    QVERIFY2(std::abs(drawn[3] - 200) < 55, QByteArray::number(drawn[3]));
}

void TestRuleSequences::eachRoundIsDrawnAnew()
{
    Session session(sceneWith(1, {repeat(400), oneOf(1, 1), add(1, 2), oneOf(1, 1), add(1, 2, 2)}));
    go(session, 1);
    run(session, 3);
    const float first = session.rules().number(0, kCount);
    QCOMPARE(first + session.rules().number(0, 2), 400.0F);
    QVERIFY2(first > 150.0F && first < 250.0F, QByteArray::number(static_cast<double>(first)));
}

/// A clip of 1.5 s three times is over after 135 steps.
void TestRuleSequences::thingsHappenToTheStep()
{
    actions::PlayClip clap;
    clap.clips = {{"clap", 1.0F}};
    Session session(sceneWith(1, {repeat(3), add(1, 1), deeper(clap, 1), add(10)}));
    go(session, 1);
    std::vector<int> at;
    float last = 0.0F;
    for (int step = 0; step < 150; ++step) {
        session.step();
        if (session.rules().number(0, kCount) != last) {
            last = session.rules().number(0, kCount);
            at.push_back(step);
        }
    }
    const std::vector<int> expected{0, 45, 90, 135};
    QCOMPARE(at, expected);
    QCOMPARE(last, 13.0F);
}

void TestRuleSequences::isTheSameForAnyNumberOfThreads()
{
    actions::PlayClip clap;
    clap.clips = {{"clap", 1.0F}, {"sit", 3.0F}};
    actions::Flee stroll;
    stroll.metres = 2.0F;
    const model::Scene scene = sceneWith(300, {repeat(0), oneOf(1, 1), deeper(clap, 2), oneOf(2, 1),
                                               deeper(stroll, 2), oneOf(1, 1), pause(0.5F, 2)});
    std::vector<model::Population> ends;
    for (const int threads : {1, 2, 4}) {
        const model::ThreadLimit limit(threads);
        Session session(scene);
        go(session, 300);
        run(session, 200);
        ends.push_back(session.frame()->population);
    }
    QVERIFY(ends[0] == ends[1]);
    QVERIFY(ends[0] == ends[2]);
}

CROWD_TEST(TestRuleSequences)
#include "tst_RuleSequences.moc"
