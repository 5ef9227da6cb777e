// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "tests/behavior/StateScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

actions::TakeOnState takeOn(StateId state, float seconds = 0.0F, float within = 0.0F)
{
    return {state, seconds, within};
}

int howManyAreRed(const Session& session)
{
    int red = 0;
    for (std::size_t row = 0; row < session.frame()->population.size(); ++row) {
        red += tintOf(session, row) == kRed ? 1 : 0;
    }
    return red;
}

/// A second state, in which they are as the scene has them.
void addBlueState(Scene& scene)
{
    State blue = keepState(scene, "blue", usualStateColumns(), scene.population.ids());
    blue.id = 2;
    scene.states.push_back(std::move(blue));
}

} // namespace

/// Rules that let people take on states, and hear of it.
class TestRuleStates : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whoIsToldTakesItOn();
    void itTakesItsTimeAndBeginsWithin();
    void theSequenceGoesOn();
    void rulesHearOfIt_data();
    void rulesHearOfIt();
    void eachHearsWhenHeBegins();
    void noRuleCallsItselfForEver();
    void twoMayCallEachOther();
    void statesThatAreGoneAreSaid();
    void theSameForAnyNumberOfRuns();
};

void TestRuleStates::whoIsToldTakesItOn()
{
    Scene scene = sceneWithState();
    scene.rules = {onEvent("cheer", {takeOn(1)})};
    Session session(scene);
    session.send("cheer", 1.0F, {2, 4});
    run(session, 2);
    QCOMPARE(howManyAreRed(session), 2);
    QCOMPARE(tintOf(session, 1), kRed);
    QCOMPARE(clipOf(session, 3), kSit);
    QCOMPARE(heightOf(session, 3), 2.0F);
    QCOMPARE(tintOf(session, 2), kBlue);
    session.send("cheer", 1.0F, {1, 2, 3});
    run(session, 2);
    QCOMPARE(howManyAreRed(session), 4);
}

void TestRuleStates::itTakesItsTimeAndBeginsWithin()
{
    Scene scene = sceneWithState(40);
    scene.rules = {onEvent("slow", {takeOn(1, 2.0F)}), onEvent("jump", {takeOn(1, 0.0F, 4.0F)})};
    scene.rules.back().id = 2;
    Session slow(scene);
    slow.send("slow", 1.0F, {1});
    run(slow, 2 + kStepsPerSecond);
    QVERIFY(std::abs(heightOf(slow, 0) - 1.5F) < 0.05F);
    Session wave(scene);
    wave.send("jump", 1.0F, peopleOf(scene, scene.states.front()));
    run(wave, 2);
    QVERIFY(howManyAreRed(wave) < 10);
    run(wave, 2 * kStepsPerSecond);
    QVERIFY(howManyAreRed(wave) > 10 && howManyAreRed(wave) < 30);
    run(wave, 2 * kStepsPerSecond + 2);
    QCOMPARE(howManyAreRed(wave), 40);
}

void TestRuleStates::theSequenceGoesOn()
{
    Scene scene = sceneWithState();
    addBlueState(scene);
    actions::Wait wait;
    wait.seconds = 1.0F;
    scene.rules = {onEvent("cheer", {takeOn(1), wait, takeOn(2), tagWith(3)})};
    Session session(scene);
    session.send("cheer", 1.0F, {1});
    run(session, 3);
    QCOMPARE(tintOf(session, 0), kRed);
    run(session, kStepsPerSecond + 2);
    QCOMPARE(tintOf(session, 0), kBlue);
    QVERIFY(hasTag(session, 0, 3));
}

void TestRuleStates::rulesHearOfIt_data()
{
    QTest::addColumn<int>("how");
    QTest::addColumn<StateId>("asked");
    QTest::addColumn<bool>("isHeard");
    QTest::newRow("in the session") << 0 << StateId{1} << true;
    QTest::newRow("in the scene") << 1 << StateId{1} << true;
    QTest::newRow("by a rule") << 2 << StateId{1} << true;
    QTest::newRow("any") << 0 << StateId{0} << true;
    QTest::newRow("another one") << 0 << StateId{2} << false;
}

void TestRuleStates::rulesHearOfIt()
{
    QFETCH(int, how);
    QFETCH(StateId, asked);
    QFETCH(bool, isHeard);
    Scene scene = sceneWithState();
    addBlueState(scene);
    scene.rules = {when(triggers::StateRecalled{asked}, {tagWith(5)}, 1),
                   onEvent("cheer", {takeOn(1)})};
    scene.rules.back().id = 2;
    Session session(scene);
    run(session, 2);
    ChangeOver change = changeOver(scene, 0.0F);
    change.ids = {1, 3};
    if (how == 0) {
        (void)session.recall(change);
    } else if (how == 1) {
        Scene now = scene;
        (void)recallState(now, scene.states.front(), change.columns, &change.ids);
        session.adopt(now, change);
    } else {
        session.send("cheer", 1.0F, {1, 3});
    }
    run(session, 4);
    QCOMPARE(hasTag(session, 0, 5), isHeard);
    QCOMPARE(hasTag(session, 2, 5), isHeard);
    QVERIFY(!hasTag(session, 1, 5));
}

void TestRuleStates::eachHearsWhenHeBegins()
{
    Scene scene = sceneWithState();
    scene.rules = {when(triggers::StateRecalled{1}, {tagWith(5)}, 1)};
    Session session(scene);
    (void)session.recall(changeOver(scene, 1.0F, {4.0F, StaggerOrder::Distance}));
    run(session, kStepsPerSecond);
    QVERIFY(hasTag(session, 0, 5) && !hasTag(session, 2, 5));
    run(session, kStepsPerSecond + 2);
    QVERIFY(hasTag(session, 2, 5) && !hasTag(session, 4, 5));
    run(session, 2 * kStepsPerSecond + 2);
    QVERIFY(hasTag(session, 4, 5));
}

void TestRuleStates::noRuleCallsItselfForEver()
{
    Scene scene = sceneWithState();
    scene.rules = {when(triggers::StateRecalled{1}, {takeOn(1)}, 7)};
    Session session(scene);
    (void)session.recall(changeOver(scene, 0.0F));
    run(session, 60);
    QCOMPARE(session.rules().count(7), std::uint64_t{5}); // once each
}

void TestRuleStates::twoMayCallEachOther()
{
    Scene scene = sceneWithState();
    addBlueState(scene);
    scene.rules = {when(triggers::StateRecalled{1}, {takeOn(2)}, 1),
                   when(triggers::StateRecalled{2}, {takeOn(1)}, 2)};
    Session session(scene);
    (void)session.recall(changeOver(scene, 0.0F));
    run(session, 60); // to and fro, some steps each: nothing hangs
    QVERIFY(session.rules().count(1) > 20 && session.rules().count(1) < 300);
}

void TestRuleStates::statesThatAreGoneAreSaid()
{
    Scene scene = sceneWithState();
    scene.rules = {onEvent("cheer", {takeOn(9), tagWith(2)})};
    Session session(scene);
    session.send("cheer", 1.0F, {1});
    run(session, 3);
    QVERIFY(hasTag(session, 0, 2));
    const auto problems = session.problems();
    QVERIFY(std::ranges::any_of(problems, [](const behavior::Problem& each) {
        return each.text.english().find("the state is not there") != std::string::npos;
    }));
}

void TestRuleStates::theSameForAnyNumberOfRuns()
{
    Scene scene = sceneWithState(60);
    scene.rules = {onEvent("jump", {takeOn(1, 1.0F, 3.0F)})};
    const auto after = [&scene] {
        Session session(scene);
        session.send("jump", 1.0F, peopleOf(scene, scene.states.front()));
        run(session, 2 * kStepsPerSecond);
        return session.frame()->population;
    };
    QCOMPARE(after(), after());
}

CROWD_TEST(TestRuleStates)
#include "tst_RuleStates.moc"
