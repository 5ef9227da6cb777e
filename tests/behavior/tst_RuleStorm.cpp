// SPDX-License-Identifier: MIT
#include <numeric>

#include <QtTest/QTest>

#include "model/base/Parallel.h"
#include "tests/behavior/RuleScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

actions::SendEvent sendTo(model::EventReach reach, float metres = 3.0F)
{
    actions::SendEvent made;
    made.event = "storm";
    made.reach = reach;
    made.metres = metres;
    return made;
}

Action playOnce()
{
    actions::PlayClip made;
    made.clips = {{"clap", 1.0F}};
    return made;
}

std::vector<model::IndividualId> allOf(const model::Scene& scene)
{
    const auto ids = scene.population.ids();
    return {ids.begin(), ids.end()};
}

constexpr model::NumberId kDone = 1;

actions::AddToNumber countOne()
{
    actions::AddToNumber more;
    more.number = kDone;
    more.value = 1.0F;
    return more;
}

/// How often countOne() was run, by everybody together.
double doneBy(Session& session, std::uint32_t people)
{
    double sum = 0.0;
    for (std::uint32_t agent = 0; agent < people; ++agent) {
        sum += static_cast<double>(session.rules().number(agent, kDone));
    }
    return sum;
}

/// The largest step of sums that grow.
template<class T>
T mostAtOnce(const std::vector<T>& sums)
{
    T most{};
    for (std::size_t i = 1; i < sums.size(); ++i) {
        most = std::max(most, sums[i] - sums[i - 1]);
    }
    return most;
}

bool isStormSaid(Session& session)
{
    return std::ranges::any_of(session.problems(), [](const behavior::Problem& problem) {
        return problem.text.english().find("than a step has room for") != std::string::npos ||
               problem.text.english().find("more events than can be under way") !=
                   std::string::npos;
    });
}

} // namespace

/// Rules that let very much happen at once, or queue without end.
class TestRuleStorm : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aStormHoldsNoStepUp_data();
    void aStormHoldsNoStepUp();
    void whoComesLastInAStormComesInTheNextStep();
    void isTheSameForAnyNumberOfThreads();
    void whoIsNearHearsIt();
    void aClipThatEndsAsksConditionsPauseAndLimit_data();
    void aClipThatEndsAsksConditionsPauseAndLimit();
    void clipsThatEndQueueNoMoreThanTheLimit();
    void aLimitHoldsInTheQueueToo();
};

void TestRuleStorm::aStormHoldsNoStepUp_data()
{
    QTest::addColumn<int>("reach");
    QTest::addColumn<int>("repeats");
    QTest::newRow("everybody tells everybody")
        << static_cast<int>(model::EventReach::Everybody) << 0;
    QTest::newRow("everybody tells those near") << static_cast<int>(model::EventReach::Near) << 0;
    QTest::newRow("a thousand times each") << static_cast<int>(model::EventReach::Everybody) << 900;
}

void TestRuleStorm::aStormHoldsNoStepUp()
{
    QFETCH(const int, reach);
    QFETCH(const int, repeats);
    model::Scene scene = rowOf(1500);
    std::vector<Action> actions;
    if (repeats > 0) {
        actions::Repeat repeat;
        repeat.times = static_cast<std::uint32_t>(repeats);
        actions.push_back(repeat);
    }
    const auto depth = static_cast<std::uint8_t>(repeats > 0 ? 1 : 0);
    // Over the whole row: everybody is near.
    actions.emplace_back(sendTo(static_cast<model::EventReach>(reach), 1e4F), depth);
    actions.emplace_back(countOne(), depth);
    scene.numbers = {{kDone, "done", 0.0F, 0.0F}};
    scene.rules = {onEvent("storm", actions)};
    Session session(scene);
    session.send("storm", 0.0F, allOf(scene));
    std::vector<std::uint64_t> fired{0};
    std::vector<double> done{0.0};
    for (int step = 0; step < 8; ++step) {
        session.step();
        fired.push_back(session.rules().count(1));
        done.push_back(doneBy(session, 1500));
    }
    QVERIFY(isStormSaid(session));
    const std::uint64_t mostFired = mostAtOnce(fired);
    QVERIFY2(mostFired < 60'000, QByteArray::number(static_cast<qulonglong>(mostFired)));
    const double mostDone = mostAtOnce(done);
    QVERIFY2(mostDone < 60'000.0, QByteArray::number(mostDone));
}

void TestRuleStorm::whoComesLastInAStormComesInTheNextStep()
{
    model::Scene scene = rowOf(2000);
    // More than a thousand things at once for each: more than there is room for in a step.
    actions::Repeat repeat;
    repeat.times = 300;
    scene.rules = {onEvent("go", {repeat, {actions::Stop(), 1}, tagWith(1)})};
    Session session(scene);
    session.send("go", 0.0F, allOf(scene));
    session.step();
    QVERIFY(hasTag(session, 0, 1));
    QVERIFY(!hasTag(session, 1999, 1));
    QVERIFY(isStormSaid(session));
    run(session, 8);
    for (std::uint32_t agent = 0; agent < 2000; ++agent) {
        QVERIFY(hasTag(session, agent, 1));
    }
}

void TestRuleStorm::isTheSameForAnyNumberOfThreads()
{
    model::Scene scene = rowOf(1500);
    scene.places = {{1, "there", {10.0F, 0.0F, 9.0F}, 2.0F}};
    actions::Flee flee;
    scene.rules = {onEvent("storm", {sendTo(model::EventReach::Everybody), flee})};
    std::vector<model::Population> ends;
    for (const int threads : {1, 4}) {
        const model::ThreadLimit limit(threads);
        Session session(scene);
        session.send("storm", 0.0F, allOf(scene));
        run(session, 8);
        ends.push_back(session.frame()->population);
    }
    QVERIFY(ends[0] == ends[1]);
}

/// As many as a look at everybody finds.
void TestRuleStorm::whoIsNearHearsIt()
{
    model::Scene scene = rowOf(400); // two metres apart
    Rule hear = onEvent("storm", {tagWith(1)});
    hear.id = 2;
    scene.rules = {onEvent("go", {sendTo(model::EventReach::Near, 9.0F)}), hear};
    Session session(scene);
    session.send("go", 0.0F, {1, 100, 101});
    run(session, 3);
    for (std::uint32_t agent = 0; agent < 400; ++agent) {
        const bool isNear = (agent >= 1 && agent <= 4) || (agent >= 95 && agent <= 104);
        QCOMPARE(hasTag(session, agent, 1), isNear);
    }
}

void TestRuleStorm::aClipThatEndsAsksConditionsPauseAndLimit_data()
{
    QTest::addColumn<bool>("isConditional");
    QTest::addColumn<float>("pause");
    QTest::addColumn<std::uint32_t>("limit");
    QTest::addColumn<std::uint64_t>("times");
    QTest::newRow("nothing") << false << 0.0F << 0U << std::uint64_t{5};
    QTest::newRow("a condition") << true << 0.0F << 0U << std::uint64_t{0};
    QTest::newRow("a pause") << false << 100.0F << 0U << std::uint64_t{1};
    QTest::newRow("a limit") << false << 0.0F << 2U << std::uint64_t{2};
}

void TestRuleStorm::aClipThatEndsAsksConditionsPauseAndLimit()
{
    QFETCH(const bool, isConditional);
    QFETCH(const float, pause);
    QFETCH(const std::uint32_t, limit);
    QFETCH(const std::uint64_t, times);
    model::Scene scene = rowOf(1);
    Rule over = when(triggers::ClipEnded(), {tagWith(1)}, 2);
    over.cooldownSeconds = pause;
    over.limit = limit;
    if (isConditional) {
        over.conditions = {conditions::HasTag{9}};
    }
    scene.rules = {onEvent("go", {playOnce()}), over};
    Session session(scene);
    for (int i = 0; i < 5; ++i) {
        session.send("go", 0.0F, {1});
        run(session, 60);
    }
    QCOMPARE(session.rules().count(2), times);
}

void TestRuleStorm::clipsThatEndQueueNoMoreThanTheLimit()
{
    model::Scene scene = rowOf(1);
    actions::Repeat repeat;
    repeat.times = 40;
    const Action clip(actions::PlayClip{{{"clap", 1.0F}}, true, 0.1F}, 1);
    Rule over = when(triggers::ClipEnded(), {actions::Stop()}, 2);
    scene.rules = {onEvent("go", {repeat, clip}), over};
    Session session(scene);
    session.send("go", 0.0F, {1});
    run(session, 600);
    QVERIFY(session.rules().count(2) >= 1);
    QVERIFY2(session.rules().count(2) <= 9,
             QByteArray::number(static_cast<qulonglong>(session.rules().count(2))));
}

void TestRuleStorm::aLimitHoldsInTheQueueToo()
{
    model::Scene scene = rowOf(1);
    Rule later = onEvent("later", {actions::Stop()});
    later.id = 2;
    later.meeting = model::RuleMeeting::Queue;
    later.limit = 1;
    scene.rules = {onEvent("go", {playOnce()}), later};
    Session session(scene);
    session.send("go", 0.0F, {1});
    run(session, 5);
    for (int i = 0; i < 6; ++i) {
        session.send("later", 0.0F, {1});
        session.step();
    }
    run(session, 120);
    QCOMPARE(session.rules().count(2), std::uint64_t{1});
}

CROWD_TEST(TestRuleStorm)
#include "tst_RuleStorm.moc"
