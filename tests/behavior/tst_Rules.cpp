// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "behavior/session/Session.h"
#include "behavior/session/SessionPlayer.h"
#include "model/base/Parallel.h"
#include "model/rules/RuleSets.h"
#include "tests/behavior/Actors.h"
#include "tests/program/Test.h"

using namespace crowd;
using behavior::Session;
using model::Action;
using model::Rule;
using namespace crowd::testing;

namespace {

Action clap()
{
    actions::PlayClip made;
    made.clips = {{"clap", 1.0F}};
    return made;
}

} // namespace

class TestRules : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aClipIsPlayedToItsEndAndNoLonger();
    void aWaveRunsAtItsSpeed();
    void conditionsAndLimitsHold();
    void laterRulesDoNotInterruptEarlierOnes();
    void aQueueWaitsForItsTurn();
    void aRuleThatRepeatsWithoutTimeIsEnded();
    void eventsInACircleNeverCloseWithinOneStep();
    void fleeingRunsFromWhereItCameFrom();
    void goingToAPlaceAndLeaving();
    void theNumberOfAnEventIsASpeed();
    void placesAreNoticed();
    void deletedPathsAreSaidByTheRulesName();
    void editsWhileItRunsTakeEffect();
    void isTheSameForAnyNumberOfThreads();
    void theThreadShowsWhatTheSessionDoes();
};

void TestRules::aClipIsPlayedToItsEndAndNoLonger()
{
    model::Scene scene = rowOf(1);
    scene.rules = {onEvent("go", {clap()})};
    Session session(scene);
    QCOMPARE(int{clipOf(session, 0)}, 0);
    session.send("go", 0.0F, {1});
    run(session, 2);
    QCOMPARE(int{clipOf(session, 0)}, 3);
    run(session, 42); // 1.5 s are 45 steps
    QCOMPARE(int{clipOf(session, 0)}, 3);
    run(session, 4);
    QCOMPARE(int{clipOf(session, 0)}, 0);
    QCOMPARE(session.rules().count(1), std::uint64_t{1});
    QVERIFY(scene.population.column(model::columns::clip)[0] == 0);
}

void TestRules::aWaveRunsAtItsSpeed()
{
    model::Scene scene = rowOf(20);
    Rule rule = onEvent("wave", {tellNear("wave", 2.5F, 0.25F), clap()});
    rule.cooldownSeconds = 60.0F;
    scene.rules = {rule};
    Session session(scene);
    session.send("wave", 0.0F, {1});
    std::vector<int> reached(20, -1);
    for (int step = 0; step < 600; ++step) {
        session.step();
        for (std::size_t row = 0; row < 20; ++row) {
            if (reached[row] < 0 && clipOf(session, row) == 3) {
                reached[row] = step;
            }
        }
    }
    QVERIFY(reached[0] >= 0 && reached[19] > reached[1]);
    // 2 m at 0.25 s/m: half a second from one to the next, to the step.
    QVERIFY(std::abs(reached[19] - reached[0] - 19 * 15) <= 19);
    QCOMPARE(session.rules().count(1), std::uint64_t{20});
}

void TestRules::conditionsAndLimitsHold()
{
    model::Scene scene = rowOf(100);
    std::vector<std::uint64_t> tags(100, 0);
    std::fill_n(tags.begin(), 50, std::uint64_t{1} << 5U);
    const auto ids = scene.population.ids();
    const std::vector<model::IndividualId> all(ids.begin(), ids.end());
    scene.population.setValues<std::uint64_t>(model::columns::tags, all, tags);
    Rule tagged = onEvent("go", {clap()});
    tagged.conditions = {conditions::HasTag{5}};
    tagged.limit = 2;
    Rule byChance = onEvent("go", {clap()});
    byChance.id = 2;
    byChance.conditions = {{conditions::HasTag{5}, true}, conditions::Chance()};
    scene.rules = {tagged, byChance};
    Session session(scene);
    for (int i = 0; i < 3; ++i) {
        session.send("go", 0.0F, all);
        run(session, 60);
    }
    QCOMPARE(session.rules().count(1), std::uint64_t{100}); // 50 people, twice each
    const std::uint64_t byChanceCount = session.rules().count(2);
    QVERIFY2(byChanceCount > 45 && byChanceCount < 105, QByteArray::number(byChanceCount));
}

void TestRules::laterRulesDoNotInterruptEarlierOnes()
{
    model::Scene scene = rowOf(1);
    actions::Wait longWait;
    longWait.seconds = 4.0F;
    Rule first = onEvent("important", {longWait});
    Rule second = onEvent("small", {clap()});
    second.id = 2;
    scene.rules = {first, second};
    Session session(scene);
    session.send("important", 0.0F, {1});
    run(session, 5);
    session.send("small", 0.0F, {1});
    run(session, 5);
    QCOMPARE(session.rules().count(2), std::uint64_t{0});
    std::swap(scene.rules[0], scene.rules[1]);
    Session other(scene);
    other.send("important", 0.0F, {1});
    run(other, 5);
    other.send("small", 0.0F, {1});
    run(other, 5);
    QCOMPARE(other.rules().count(2), std::uint64_t{1});
}

void TestRules::aQueueWaitsForItsTurn()
{
    model::Scene scene = rowOf(1);
    Rule first = onEvent("a", {clap()});
    actions::AddTag tag;
    tag.tag = 7;
    Rule second = onEvent("b", {tag});
    second.id = 2;
    second.meeting = model::RuleMeeting::Queue;
    scene.rules = {first, second};
    Session session(scene);
    session.send("a", 0.0F, {1});
    run(session, 3);
    session.send("b", 0.0F, {1});
    run(session, 3);
    QCOMPARE(session.rules().tags(0), std::uint64_t{0});
    run(session, 60);
    QCOMPARE(session.rules().tags(0), std::uint64_t{1} << 7U);
}

void TestRules::aRuleThatRepeatsWithoutTimeIsEnded()
{
    model::Scene scene = rowOf(1);
    scene.rules = {onEvent("spin", {actions::Stop(), actions::Again()})};
    Session session(scene);
    session.send("spin", 0.0F, {1});
    run(session, 5);
    QCOMPARE(session.rules().problems().size(), std::size_t{1});
    QVERIFY(session.rules().problems().front().text.english().find("\"spin\" repeats") !=
            std::string::npos);
}

void TestRules::eventsInACircleNeverCloseWithinOneStep()
{
    model::Scene scene = rowOf(2);
    scene.rules = {onEvent("echo", {tellNear("echo", 5.0F)})};
    Session session(scene);
    session.send("echo", 0.0F, {1});
    run(session, 30);
    const std::uint64_t count = session.rules().count(1);
    QVERIFY2(count >= 10 && count <= 31, QByteArray::number(count)); // one a step
}

void TestRules::fleeingRunsFromWhereItCameFrom()
{
    model::Scene scene = rowOf(2);
    actions::SetSpeed speed;
    speed.value = 3.0F;
    actions::Flee flee;
    flee.metres = 6.0F;
    scene.rules = {onEvent("panic", {speed, flee})};
    Session session(scene);
    session.send("panic", 0.0F, {1, 2}); // from between them
    run(session, 150);
    QVERIFY2(placeOf(session, 0).x < -5.0F, QByteArray::number(placeOf(session, 0).x));
    QVERIFY2(placeOf(session, 1).x > 7.0F, QByteArray::number(placeOf(session, 1).x));
}

void TestRules::goingToAPlaceAndLeaving()
{
    model::Scene scene = rowOf(1);
    scene.places = {{1, "door", {0.0F, 0.0F, 5.0F}, 0.5F}};
    actions::GoToPlace go;
    go.place = 1;
    scene.rules = {onEvent("out", {go, actions::LeaveScene()})};
    Session session(scene);
    session.send("out", 0.0F, {1});
    run(session, 60);
    QVERIFY(placeOf(session, 0).z > 1.0F);
    run(session, 200);
    QVERIFY(placeOf(session, 0).y < -1000.0F);
    scene.places[0].role = model::PlaceRole::Exit;
    scene.rules = {onEvent("out", {go})};
    Session byExit(scene);
    byExit.send("out", 0.0F, {1});
    run(byExit, 200);
    QVERIFY(placeOf(byExit, 0).y < -1000.0F);
}

void TestRules::theNumberOfAnEventIsASpeed()
{
    model::Scene scene = rowOf(1);
    scene.places = {{1, "a", {0.0F, 0.0F, 0.0F}, 0.5F}, {2, "b", {0.0F, 0.0F, 60.0F}, 0.5F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1, 2}}};
    const std::vector<model::IndividualId> ids{1};
    const std::vector<model::PathId> path{1};
    scene.population.setValues<model::PathId>(model::columns::path, ids, path);
    scene.rules = model::rulesOf(model::RuleSet::Pedestrians, scene);
    model::giveIds(scene.rules, scene);
    scene.rules.resize(1); // "run"
    Session session(scene);
    run(session, 90);
    const float before = placeOf(session, 0).z;
    session.send("run", 2.8F, {1});
    run(session, 60);
    const float walked = placeOf(session, 0).z;
    run(session, 30);
    const float ran = placeOf(session, 0).z - walked;
    QVERIFY2(before / 3.0F < 1.6F, QByteArray::number(before / 3.0F));
    QVERIFY2(std::abs(ran - 2.8F) < 0.15F, QByteArray::number(ran));
    QCOMPARE(int{clipOf(session, 0)}, 2); // in the clip to run with
}

void TestRules::placesAreNoticed()
{
    model::Scene scene = rowOf(1);
    scene.places = {{1, "a", {0.0F, 0.0F, 0.0F}, 0.0F},
                    {2, "b", {0.0F, 0.0F, 6.0F}, 0.2F},
                    {3, "hall", {0.0F, 0.0F, 3.0F}, 1.0F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1, 2}}};
    const std::vector<model::IndividualId> ids{1};
    const std::vector<model::PathId> path{1};
    scene.population.setValues<model::PathId>(model::columns::path, ids, path);
    const auto rule = [&](const model::Trigger& trigger) {
        Rule made;
        made.id = static_cast<model::RuleId>(scene.rules.size() + 1);
        made.trigger = trigger;
        made.actions = {actions::AddTag()};
        scene.rules.push_back(made);
    };
    rule(triggers::Start());
    rule(triggers::Entered{3});
    rule(triggers::Left{3});
    rule(triggers::Arrived{2});
    rule(triggers::PathEnded());
    scene.rules.back().meeting = model::RuleMeeting::Queue; // it happens as he arrives
    rule(triggers::Every{1.0F});
    Session session(scene);
    run(session, 300);
    for (model::RuleId id = 1; id <= 5; ++id) {
        QCOMPARE(session.rules().count(id), std::uint64_t{1});
    }
    const std::uint64_t every = session.rules().count(6);
    QVERIFY2(every >= 8 && every <= 12, QByteArray::number(every));
}

void TestRules::deletedPathsAreSaidByTheRulesName()
{
    model::Scene scene = rowOf(1);
    actions::FollowPath follow;
    follow.path = 9;
    scene.rules = {onEvent("walk", {follow})};
    Session session(scene);
    session.send("walk", 0.0F, {1});
    run(session, 3);
    QCOMPARE(session.rules().problems().size(), std::size_t{1});
    QVERIFY(session.rules().problems().front().text.english().find("\"walk\"") !=
            std::string::npos);
}

void TestRules::editsWhileItRunsTakeEffect()
{
    model::Scene scene = rowOf(3);
    scene.places = {{1, "a", {0.0F, 0.0F, 0.0F}, 0.0F}, {2, "b", {0.0F, 0.0F, 40.0F}, 0.0F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1, 2}}};
    const std::vector<model::IndividualId> ids{1};
    const std::vector<model::PathId> path{1};
    scene.population.setValues<model::PathId>(model::columns::path, ids, path);
    Session session(scene);
    run(session, 60);
    const float before = placeOf(session, 0).z;
    QVERIFY(before > 1.0F);
    // The place moves aside, somebody comes, somebody goes.
    scene.places[1].position = {40.0F, 0.0F, before};
    const std::vector<model::IndividualId> second{2};
    (void)scene.population.remove(second);
    auto rows = model::IndividualRows::withDefaults({8});
    rows.column(model::columns::templateId)[0] = 1;
    rows.column(model::columns::path)[0] = 1;
    scene.population.add(rows);
    session.adopt(scene);
    run(session, 120);
    QCOMPARE(session.frame()->population.size(), std::size_t{3});
    QVERIFY(placeOf(session, 0).x > 2.0F);
    QVERIFY(std::abs(placeOf(session, 0).z - before) < 1.0F);
    QVERIFY(placeOf(session, 2).x > 2.0F);
    // A new position in the scene is one in the session; a kept pose changes nothing.
    const std::vector<glm::vec3> there{{-30.0F, 0.0F, 0.0F}};
    scene.population.setValues<glm::vec3>(model::columns::position, ids, there);
    session.adopt(scene);
    run(session, 1);
    QVERIFY(placeOf(session, 0).x < -29.0F);
    const std::vector<glm::vec3> kept{{50.0F, 0.0F, 0.0F}};
    scene.population.setValues<glm::vec3>(model::columns::position, ids, kept);
    session.adopt(scene, true);
    run(session, 1);
    QVERIFY(placeOf(session, 0).x < -28.0F);
}

void TestRules::isTheSameForAnyNumberOfThreads()
{
    model::Scene scene = rowOf(5000);
    scene.places = {{1, "a", {0.0F, 0.0F, 20.0F}, 9.0F}, {2, "b", {60.0F, 0.0F, 20.0F}, 9.0F}};
    scene.paths = {{1, "way", model::PathKind::Cyclic, {1, 2}}};
    const auto ids = scene.population.ids();
    const std::vector<model::IndividualId> all(ids.begin(), ids.end());
    const model::PathId path = 1;
    std::vector<model::PathId> paths(all.size(), path);
    scene.population.setValues<model::PathId>(model::columns::path, all, paths);
    scene.rules = model::rulesOf(model::RuleSet::Pedestrians, scene);
    for (const Rule& rule : model::rulesOf(model::RuleSet::Panic, scene)) {
        scene.rules.push_back(rule);
    }
    for (std::size_t i = 0; i < scene.rules.size(); ++i) {
        scene.rules[i].id = static_cast<model::RuleId>(i + 1);
    }
    std::vector<model::Population> ends;
    for (const int threads : {1, 2, 4}) {
        const model::ThreadLimit limit(threads);
        Session session(scene);
        run(session, 20);
        session.send("panic", 0.0F, {100, 101, 102});
        run(session, 40);
        ends.push_back(session.frame()->population);
    }
    QVERIFY(ends[0] == ends[1]);
    QVERIFY(ends[0] == ends[2]);
}

void TestRules::theThreadShowsWhatTheSessionDoes()
{
    model::Scene scene = rowOf(4);
    scene.places = {{1, "a", {0.0F, 0.0F, 0.0F}, 0.5F}, {2, "b", {0.0F, 0.0F, 30.0F}, 0.5F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1, 2}}};
    const std::vector<model::IndividualId> ids{1, 2, 3, 4};
    const std::vector<model::PathId> paths(4, 1);
    scene.population.setValues<model::PathId>(model::columns::path, ids, paths);
    Session alone(scene);
    run(alone, 45);
    behavior::SessionPlayer player([] {});
    player.start(scene);
    player.request(1.5);
    QTRY_VERIFY(player.available() >= 1.5 - 1e-6);
    model::CrowdFrame frame{scene.population, nullptr, 1.5};
    player.pose(frame);
    const auto shown = frame.population.column(model::columns::position);
    const auto expected = alone.frame();
    const auto wanted = expected->population.column(model::columns::position);
    for (std::size_t row = 0; row < 4; ++row) {
        QVERIFY(glm::distance(shown[row], wanted[row]) < 1e-4F);
    }
    // Between two steps somebody is between two places.
    model::CrowdFrame between{scene.population, nullptr, 1.45};
    player.pose(between);
    const float z = between.population.column(model::columns::position)[0].z;
    QVERIFY(z < wanted[0].z && z > wanted[0].z - 0.1F);
    player.stop();
    QVERIFY(!player.isRunning());
}

CROWD_TEST(TestRules)
#include "tst_Rules.moc"
