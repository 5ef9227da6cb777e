// SPDX-License-Identifier: MIT
#include <cmath>

#include <QtTest/QTest>

#include "model/base/Parallel.h"
#include "tests/behavior/Actors.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;
using model::ActionAim;

namespace {

constexpr std::uint8_t kStar = 6;

/// About those with the star, or the place.
template<class Kind>
Kind about(ActionAim aim, float seconds = 0.0F)
{
    Kind made;
    made.aim = aim;
    made.tag = kStar;
    if constexpr (requires { made.seconds; }) {
        made.seconds = seconds;
    }
    if constexpr (requires { made.metres; }) {
        made.metres = 1.5F;
    }
    return made;
}

Action marked(std::uint8_t tag)
{
    actions::AddTag made;
    made.tag = tag;
    return made;
}

bool isMarked(Session& session, std::uint32_t agent, std::uint8_t tag)
{
    return (session.rules().tags(agent) >> tag & 1U) != 0;
}

void tagOne(model::Scene& scene, model::IndividualId id)
{
    const std::vector<model::IndividualId> ids{id};
    const std::vector<std::uint64_t> tags{std::uint64_t{1} << kStar};
    scene.population.setValues<std::uint64_t>(model::columns::tags, ids, tags);
}

/// Person 1 walks 30 m along X when "go" reaches him.
Rule walkOff()
{
    actions::GoToPlace go;
    go.place = 1;
    Rule rule = onEvent("go", {tellNear("come", 100.0F), go});
    return rule;
}

float between(const Session& session, std::size_t a, std::size_t b)
{
    return behavior::flatDistance(placeOf(session, a), placeOf(session, b));
}

/// How far somebody's face points past another one, radians.
float pastBy(const Session& session, std::size_t who, const glm::vec3& point)
{
    const glm::vec3 way = point - placeOf(session, who);
    const float heading = session.frame()->population.column(model::columns::heading)[who];
    return std::fabs(std::remainder(heading - std::atan2(way.x, way.z), 6.2831853F));
}

} // namespace

class TestRuleAims : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whoSentTheEventIsFollowed();
    void whoFallsBehindHurries();
    void followingEndsInTime();
    void theNearestTaggedOneIsFollowedAndKept();
    void nobodyToFollowIsSaid();
    void goingToSomebodyEndsBesideHim();
    void whoNobodyCatchesIsGivenUp();
    void lookingKeepsFacingWhoMoves_data();
    void lookingKeepsFacingWhoMoves();
    void lookingIsBrokenOffByAnotherRule();
    void fleeingRunsFromTheAim_data();
    void fleeingRunsFromTheAim();
    void isTheSameForAnyNumberOfThreads();
};

void TestRuleAims::whoSentTheEventIsFollowed()
{
    model::Scene scene = rowOf(3);
    scene.places.push_back({1, "far", {4.0F, 0.0F, 30.0F}, 0.1F});
    Rule come = onEvent("come", {about<actions::Follow>(ActionAim::Sender)});
    come.id = 2;
    scene.rules = {walkOff(), come};
    Session session(scene);
    session.send("go", 0.0F, {3});
    run(session, 60);
    QVERIFY(placeOf(session, 2).z > 1.5F);
    run(session, 900);
    QVERIFY(placeOf(session, 2).z > 29.0F); // there
    for (const std::size_t follower : {0U, 1U}) {
        const float away = between(session, follower, 2);
        QVERIFY2(away > 0.5F && away < 2.2F, QByteArray::number(static_cast<double>(away)));
        QVERIFY(pastBy(session, follower, placeOf(session, 2)) < 0.3F);
    }
    // He stands: nobody fidgets around him.
    const glm::vec3 rest = placeOf(session, 0);
    run(session, 90);
    QVERIFY(glm::distance(rest, placeOf(session, 0)) < 0.05F);
}

void TestRuleAims::whoFallsBehindHurries()
{
    model::Scene scene = rowOf(2);
    scene.places.push_back({1, "far", {2.0F, 0.0F, 60.0F}, 0.1F});
    scene.places.push_back({2, "home", {0.0F, 0.0F, 0.0F}, 0.1F});
    actions::SetSpeed fast;
    fast.value = 2.5F;
    Rule off = walkOff();
    off.actions.insert(off.actions.begin(), fast);
    Rule come = onEvent("come", {about<actions::Follow>(ActionAim::Sender)});
    come.id = 2;
    actions::GoToPlace goHome;
    goHome.place = 2;
    Rule home = onEvent("home", {goHome});
    home.id = 3;
    scene.rules = {home, off, come}; // the first has priority
    Session session(scene);
    session.send("go", 0.0F, {2});
    run(session, 400);
    const float away = between(session, 0, 1);
    QVERIFY2(placeOf(session, 1).z > 25.0F && away < 5.0F,
             QByteArray::number(static_cast<double>(away)));
    // With something else to do he walks as he did before.
    session.send("home", 0.0F, {1});
    run(session, 90);
    const glm::vec3 from = placeOf(session, 0);
    run(session, 30);
    const float speed = glm::distance(from, placeOf(session, 0));
    QVERIFY2(speed > 1.0F && speed < 1.8F, QByteArray::number(static_cast<double>(speed)));
}

void TestRuleAims::followingEndsInTime()
{
    model::Scene scene = rowOf(2);
    scene.places.push_back({1, "far", {0.0F, 0.0F, 40.0F}, 0.1F});
    Rule come = onEvent("come", {about<actions::Follow>(ActionAim::Sender, 5.0F), marked(1)});
    come.id = 2;
    scene.rules = {walkOff(), come};
    Session session(scene);
    session.send("go", 0.0F, {1});
    run(session, 120);
    QVERIFY(!isMarked(session, 1, 1));
    run(session, 60);
    QVERIFY(isMarked(session, 1, 1));
    run(session, 30);
    const glm::vec3 rest = placeOf(session, 1);
    run(session, 60);
    QVERIFY(glm::distance(rest, placeOf(session, 1)) < 0.05F);
}

void TestRuleAims::theNearestTaggedOneIsFollowedAndKept()
{
    model::Scene scene = rowOf(6); // at 0, 2, 4, … 10
    scene.places.push_back({1, "far", {2.0F, 0.0F, 20.0F}, 0.1F});
    tagOne(scene, 2);
    tagOne(scene, 6);
    actions::GoToPlace go;
    go.place = 1;
    Rule walk = onEvent("go", {go});
    Rule follow = onEvent("follow", {about<actions::Follow>(ActionAim::Tagged)});
    follow.id = 2;
    scene.rules = {walk, follow};
    Session session(scene);
    session.send("follow", 0.0F, {1});
    run(session, 30);
    session.send("go", 0.0F, {2});
    run(session, 900);
    QVERIFY(placeOf(session, 1).z > 19.0F);
    QVERIFY(between(session, 0, 1) < 2.2F); // though the other one was nearer for long
    QVERIFY(glm::distance(placeOf(session, 5), {10.0F, 0.0F, 0.0F}) < 0.01F);
}

void TestRuleAims::nobodyToFollowIsSaid()
{
    model::Scene scene = rowOf(2);
    scene.rules = {onEvent("come", {about<actions::Follow>(ActionAim::Sender), marked(1)}),
                   onEvent("seek", {about<actions::Follow>(ActionAim::Tagged), marked(2)})};
    scene.rules[1].id = 2;
    Session session(scene);
    session.send("come", 0.0F, {1});
    session.send("seek", 0.0F, {2});
    run(session, 3);
    QCOMPARE(session.rules().problems().size(), std::size_t{1});
    QVERIFY(session.rules().problems().front().text.english().find(
                "\"come\" follows whoever sent") != std::string::npos);
    QVERIFY(isMarked(session, 0, 1) && isMarked(session, 1, 2)); // on with the next
}

void TestRuleAims::goingToSomebodyEndsBesideHim()
{
    model::Scene scene = rowOf(5);
    tagOne(scene, 5);
    scene.rules = {onEvent("meet", {about<actions::GoToPerson>(ActionAim::Tagged), marked(1)})};
    Session session(scene);
    session.send("meet", 0.0F, {1, 5});
    run(session, 30);
    QVERIFY(!isMarked(session, 0, 1));
    QVERIFY(isMarked(session, 4, 1)); // there is no other one
    run(session, 300);
    const float away = between(session, 0, 4);
    QVERIFY2(away < 1.8F, QByteArray::number(static_cast<double>(away)));
    QVERIFY(isMarked(session, 0, 1));
    QVERIFY(pastBy(session, 0, placeOf(session, 4)) < 0.3F);
}

void TestRuleAims::whoNobodyCatchesIsGivenUp()
{
    model::Scene scene = rowOf(2);
    scene.places.push_back({1, "far", {0.0F, 0.0F, 500.0F}, 0.1F});
    actions::SetSpeed fast;
    fast.value = 4.0F;
    Rule off = walkOff();
    off.actions.insert(off.actions.begin(), fast);
    Rule meet = onEvent("come", {about<actions::GoToPerson>(ActionAim::Sender, 6.0F), marked(1)});
    meet.id = 2;
    scene.rules = {off, meet};
    Session session(scene);
    session.send("go", 0.0F, {1});
    run(session, 170);
    QVERIFY(!isMarked(session, 1, 1));
    run(session, 30);
    QVERIFY(isMarked(session, 1, 1));
}

void TestRuleAims::lookingKeepsFacingWhoMoves_data()
{
    QTest::addColumn<int>("aim");
    QTest::newRow("who sent it") << static_cast<int>(ActionAim::Sender);
    QTest::newRow("the nearest tagged one") << static_cast<int>(ActionAim::Tagged);
    QTest::newRow("a place") << static_cast<int>(ActionAim::Place);
}

void TestRuleAims::lookingKeepsFacingWhoMoves()
{
    QFETCH(const int, aim);
    model::Scene scene = rowOf(2);
    scene.places.push_back({1, "there", {-6.0F, 0.0F, 20.0F}, 0.1F});
    tagOne(scene, 1);
    auto look = about<actions::LookAt>(static_cast<ActionAim>(aim), 12.0F);
    look.place = 1;
    Rule watch = onEvent("come", {look, marked(1)});
    watch.id = 2;
    scene.rules = {walkOff(), watch};
    Session session(scene);
    session.send("go", 0.0F, {1});
    run(session, 60);
    for (int i = 0; i < 8; ++i) {
        run(session, 30);
        const bool isPlace = static_cast<ActionAim>(aim) == ActionAim::Place;
        QVERIFY(pastBy(session, 1, isPlace ? scene.places.front().position : placeOf(session, 0)) <
                0.2F);
    }
    QVERIFY(!isMarked(session, 1, 1));
    run(session, 90);
    QVERIFY(isMarked(session, 1, 1));
    QVERIFY(glm::distance(placeOf(session, 1), {2.0F, 0.0F, 0.0F}) < 0.05F);
}

void TestRuleAims::lookingIsBrokenOffByAnotherRule()
{
    model::Scene scene = rowOf(2);
    Rule wake = onEvent("wake", {marked(2)});
    Rule watch = onEvent("look", {about<actions::LookAt>(ActionAim::Sender), marked(1)});
    watch.id = 2;
    scene.rules = {wake, watch};
    Session session(scene);
    session.send("look", 0.0F, {1, 2});
    run(session, 300);
    QVERIFY(!isMarked(session, 0, 1)); // for ever
    session.send("wake", 0.0F, {1});
    run(session, 3);
    QVERIFY(isMarked(session, 0, 2) && !isMarked(session, 0, 1));
}

void TestRuleAims::fleeingRunsFromTheAim_data()
{
    lookingKeepsFacingWhoMoves_data();
}

void TestRuleAims::fleeingRunsFromTheAim()
{
    QFETCH(const int, aim);
    model::Scene scene = rowOf(3);
    scene.places.push_back({1, "there", {6.0F, 0.0F, 0.0F}, 0.1F});
    tagOne(scene, 3);
    auto flee = about<actions::Flee>(static_cast<ActionAim>(aim));
    flee.place = 1;
    flee.metres = 5.0F;
    Rule shout = onEvent("shout", {tellNear("run", 100.0F)});
    Rule away = onEvent("run", {flee});
    away.id = 2;
    scene.rules = {shout, away};
    Session session(scene);
    session.send("shout", 0.0F, {3}); // he and the place are on the right of the others
    run(session, 300);
    for (const std::size_t who : {0U, 1U}) {
        const float gone = 2.0F * static_cast<float>(who) - placeOf(session, who).x;
        QVERIFY2(gone > 4.0F && gone < 6.0F, QByteArray::number(static_cast<double>(gone)));
    }
}

void TestRuleAims::isTheSameForAnyNumberOfThreads()
{
    model::Scene scene = rowOf(200);
    scene.places.push_back({1, "there", {100.0F, 0.0F, 40.0F}, 2.0F});
    for (const model::IndividualId id : {3U, 90U, 170U}) {
        tagOne(scene, id);
    }
    scene.rules = {walkOff(), onEvent("come", {about<actions::Follow>(ActionAim::Tagged, 3.0F),
                                               about<actions::LookAt>(ActionAim::Sender, 2.0F),
                                               about<actions::GoToPerson>(ActionAim::Sender),
                                               about<actions::Flee>(ActionAim::Tagged)})};
    scene.rules[1].id = 2;
    std::vector<model::Population> ends;
    for (const int threads : {1, 2, 4}) {
        const model::ThreadLimit limit(threads);
        Session session(scene);
        session.send("go", 0.0F, {3, 90});
        run(session, 300);
        ends.push_back(session.frame()->population);
    }
    QVERIFY(ends[0] == ends[1]);
    QVERIFY(ends[0] == ends[2]);
}

CROWD_TEST(TestRuleAims)
#include "tst_RuleAims.moc"
