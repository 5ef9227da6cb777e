// SPDX-License-Identifier: MIT
#include <cmath>

#include <QtTest/QTest>
#include <glm/geometric.hpp>

#include "behavior/motion/PathRoutes.h"
#include "behavior/motion/WalkParties.h"
#include "tests/behavior/StateScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

constexpr RelationKindId kFamily = 1;
constexpr RelationKindId kFriends = 2;
constexpr RelationKindId kLeader = 4;
constexpr RelationKindId kRivals = 5;

void relate(Scene& scene, std::vector<Relation> relations)
{
    scene.relations.put(relations);
}

RelationKind& kindOf(Scene& scene, RelationKindId id)
{
    return *std::ranges::find(scene.relationKinds, id, &RelationKind::id);
}

void walkAlong(Scene& scene, std::vector<IndividualId> ids, PathId path)
{
    const std::vector<PathId> paths(ids.size(), path);
    scene.population.setValues(columns::path, std::span<const IndividualId>(ids),
                               std::span<const PathId>(paths));
}

void putAt(Scene& scene, IndividualId id, const glm::vec3& at)
{
    scene.population.setValues(columns::position, std::vector<IndividualId>{id},
                               std::span<const glm::vec3>(&at, 1));
}

/// A path of two places from z = 0 to z = 40, and one back.
void addStreet(Scene& scene)
{
    scene.places.push_back({1, "south", {0.0F, 0.0F, 0.0F}, 1.0F});
    scene.places.push_back({2, "north", {0.0F, 0.0F, 40.0F}, 1.0F});
    scene.paths.push_back({1, "up", PathKind::Simple, {1, 2}});
    scene.paths.push_back({2, "down", PathKind::Simple, {2, 1}});
}

float headingOf(const Session& session, std::size_t row)
{
    return session.frame()->population.column(columns::heading)[row];
}

float apart(const Session& session, std::size_t a, std::size_t b)
{
    return glm::distance(placeOf(session, a), placeOf(session, b));
}

/// The least distance of two who meet in a street, over their whole way.
float leastWhenMeeting(bool areRivals)
{
    Scene scene = rowOf(2);
    addStreet(scene);
    putAt(scene, 1, {0.0F, 0.0F, 5.0F});
    putAt(scene, 2, {0.15F, 0.0F, 25.0F});
    walkAlong(scene, {1}, 1);
    walkAlong(scene, {2}, 2);
    if (areRivals) {
        relate(scene, {{1, 2, 1.0F, kRivals}});
    }
    Session session(scene);
    float least = 1e9F;
    for (int i = 0; i < 12 * kStepsPerSecond; ++i) {
        session.step();
        least = std::min(least, apart(session, 0, 1));
    }
    return least;
}

/// How far four who walk a street at paces of their own are from the first to the last.
float spreadOf(bool areFamily)
{
    Scene scene = rowOf(4);
    addStreet(scene);
    const std::vector<IndividualId> ids{1, 2, 3, 4};
    const std::vector<float> paces{1.0F, 1.2F, 1.4F, 1.6F};
    for (const IndividualId id : ids) {
        putAt(scene, id, {0.7F * static_cast<float>(id) - 1.75F, 0.0F, 1.0F});
    }
    scene.population.setValues(columns::walkSpeed, std::span<const IndividualId>(ids),
                               std::span<const float>(paces));
    walkAlong(scene, ids, 1);
    if (areFamily) {
        relate(scene, {{1, 2, 1.0F, kFamily}, {2, 3, 1.0F, kFamily}, {3, 4, 1.0F, kFamily}});
    }
    Session session(scene);
    run(session, 15 * kStepsPerSecond);
    float low = 1e9F;
    float high = -1e9F;
    for (std::size_t row = 0; row < 4; ++row) {
        low = std::min(low, placeOf(session, row).z);
        high = std::max(high, placeOf(session, row).z);
    }
    return high - low;
}

} // namespace

/// What people who are related do while it plays, and rules that speak of them.
class TestCompanions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingHappensWithoutRelations();
    void whoIsLedFollows();
    void rivalsGiveEachOtherABerth();
    void aFamilyKeepsTogether();
    void abreastOrInLine();
    void aLegIsAsWideAsItsPlaces();
    void familiesDoNotPushEachOtherOffThePath();
    void friendsTurnToEachOther();
    void eventsGoFromOneToTheNext();
    void aCircleOfFriendsHearsItOnce();
    void rulesReachThoseRelated();
    void conditionsCountThem();
    void rulesHearOfWhatTheyDo();
    void aimsAreThoseRelated();
    void editsAreFollowed();
    void theSameForAnyNumberOfRuns();
};

void TestCompanions::nothingHappensWithoutRelations()
{
    Scene scene = rowOf(3);
    QVERIFY(!scene.hasBehaviour());
    relate(scene, {{1, 2, 1.0F, kFriends}});
    QVERIFY(scene.hasBehaviour());
    kindOf(scene, kFriends).facesEachOther = false;
    QVERIFY(!scene.hasBehaviour());
}

void TestCompanions::whoIsLedFollows()
{
    Scene scene = rowOf(3);
    addStreet(scene);
    walkAlong(scene, {1}, 1);
    relate(scene, {{1, 2, 1.0F, kLeader}});
    Session session(scene);
    run(session, 20 * kStepsPerSecond);
    QVERIFY2(placeOf(session, 0).z > 15.0F, "the leader walks");
    QVERIFY2(apart(session, 0, 1) < 4.5F, qPrintable(QString::number(apart(session, 0, 1))));
    QVERIFY(placeOf(session, 2).z < 1.0F); // nobody leads him
    run(session, 30 * kStepsPerSecond);
    QVERIFY(apart(session, 0, 1) < 3.5F);
    const glm::vec3 rest = placeOf(session, 1);
    run(session, 2 * kStepsPerSecond);
    QVERIFY(glm::distance(placeOf(session, 1), rest) < 0.3F); // there he stands
}

void TestCompanions::rivalsGiveEachOtherABerth()
{
    const float strangers = leastWhenMeeting(false);
    const float rivals = leastWhenMeeting(true);
    QVERIFY2(rivals > strangers + 0.4F,
             qPrintable(QStringLiteral("%1 %2").arg(strangers).arg(rivals)));
}

void TestCompanions::aFamilyKeepsTogether()
{
    const float strangers = spreadOf(false);
    const float family = spreadOf(true);
    QVERIFY2(family < 0.35F * strangers,
             qPrintable(QStringLiteral("%1 %2").arg(strangers).arg(family)));
}

void TestCompanions::abreastOrInLine()
{
    using behavior::WalkParties;
    WalkParties parties;
    const std::vector<std::uint32_t> groups{kRelatedParty + 3, kRelatedParty + 3, 7, 7};
    const auto of = parties.setGroups(groups);
    parties.beginStep();
    for (std::size_t i = 0; i < of.size(); ++i) {
        parties.add(of[i], 0, {0.0F, 0.0F}, 1.0F);
    }
    parties.endStep();
    const auto speedAt = [&](std::size_t member, const glm::vec2& at) {
        float speed = 1.0F;
        glm::vec2 sideways(0.0F);
        WalkParties::keepTogether(*parties.find(of[member], 0), at, {0.0F, 1.0F}, speed, sideways);
        return speed;
    };
    QVERIFY(speedAt(0, {0.4F, 0.5F}) < 1.0F); // before the one beside him: waits
    QVERIFY(speedAt(0, {0.4F, -0.5F}) > 1.0F);
    QCOMPARE(speedAt(0, {0.0F, 0.5F}), 1.0F); // in line there is no room beside
    QCOMPARE(speedAt(2, {0.4F, 0.5F}), 1.0F); // groups are looser
}

void TestCompanions::aLegIsAsWideAsItsPlaces()
{
    behavior::Route route;
    route.stops.push_back({1, {0.0F, 0.0F}, 0.0F, 1.0F});
    route.stops.push_back({2, {10.0F, 0.0F}, 0.0F, 3.0F});
    route.stops.push_back({3, {10.0F, 10.0F}, 0.0F, 1.0F});
    QCOMPARE(route.backToLeg(1, {5.0F, 1.9F}), glm::vec2(0.0F)); // two metres in its middle
    const glm::vec2 back = route.backToLeg(1, {5.0F, 4.0F});
    QVERIFY(glm::distance(back, glm::vec2(0.0F, -2.0F)) < 1e-5F);
    // Before its first place: only that one counts, unless the path is closed.
    QVERIFY(glm::distance(route.backToLeg(0, {0.0F, 3.0F}), glm::vec2(0.0F, -2.0F)) < 1e-5F);
    route.kind = PathKind::Cyclic;
    QCOMPARE(route.backToLeg(0, {5.0F, 5.0F}), glm::vec2(0.0F));
    // Two places on one spot.
    route.stops[1].position = {0.0F, 0.0F};
    QVERIFY(std::isfinite(route.backToLeg(1, {2.0F, 8.0F}).x));
}

/// Crowded, round a square whose legs are three metres wide.
void TestCompanions::familiesDoNotPushEachOtherOffThePath()
{
    constexpr IndividualId kPeople = 40;
    Scene scene = rowOf(kPeople);
    for (PlaceId corner = 0; corner < 4; ++corner) {
        const float x = corner == 1 || corner == 2 ? 7.0F : -7.0F;
        const float z = corner > 1 ? 8.0F : -8.0F;
        scene.places.push_back({corner + 1, "corner", {x, 0.0F, z}, 1.5F});
    }
    scene.paths.push_back({1, "round", PathKind::Cyclic, {1, 2, 3, 4}});
    std::vector<IndividualId> all;
    for (IndividualId id = 1; id <= kPeople; ++id) {
        all.push_back(id);
        const auto at = static_cast<float>(id - 1);
        putAt(scene, id, {-6.0F + 0.3F * at, 0.0F, id % 2 == 0 ? -8.4F : -7.6F});
        if (id % 4 != 0) {
            relate(scene, {{id, id + 1, 1.0F, kFamily}}); // four in a row
        }
    }
    walkAlong(scene, all, 1);
    Session session(scene);
    int outside = 0;
    int looks = 0;
    for (int second = 0; second < 45; ++second) {
        run(session, kStepsPerSecond);
        for (std::size_t row = 0; row < kPeople; ++row) {
            const glm::vec3 at = placeOf(session, row);
            const float beside = std::max(std::abs(at.x) - 7.0F, std::abs(at.z) - 8.0F);
            outside += beside > 1.5F + 0.3F ? 1 : 0;
            ++looks;
        }
    }
    QVERIFY2(outside < looks / 50, qPrintable(QStringLiteral("%1 of %2").arg(outside).arg(looks)));
}

void TestCompanions::friendsTurnToEachOther()
{
    Scene scene = rowOf(3); // two metres apart along X, facing +Z
    relate(scene, {{1, 2, 1.0F, kFriends}});
    Session session(scene);
    run(session, 3 * kStepsPerSecond);
    const float quarter = 1.5708F;
    QVERIFY(std::fabs(headingOf(session, 0) - quarter) < 0.1F);
    QVERIFY(std::fabs(headingOf(session, 1) + quarter) < 0.1F);
    QVERIFY(std::fabs(headingOf(session, 2)) < 0.01F);
    kindOf(scene, kFriends).faceMetres = 1.0F; // further off they mind their own business
    Session far(scene);
    run(far, 3 * kStepsPerSecond);
    QVERIFY(std::fabs(headingOf(far, 0)) < 0.01F);
}

void TestCompanions::eventsGoFromOneToTheNext()
{
    Scene scene = rowOf(5);
    for (IndividualId id = 1; id < 5; ++id) {
        relate(scene, {{id, id + 1, 1.0F, kLeader}});
    }
    kindOf(scene, kLeader).walk = RelationWalk::Own;
    kindOf(scene, kLeader).passSeconds = {0.5F, 0.5F};
    scene.rules = {onEvent("go", {tagWith(3)})};
    Session session(scene);
    session.send("go", 1.0F, {2});
    run(session, 3);
    QVERIFY(hasTag(session, 1, 3) && !hasTag(session, 2, 3));
    run(session, 16);
    QVERIFY(hasTag(session, 2, 3) && !hasTag(session, 3, 3));
    run(session, 40);
    QVERIFY(hasTag(session, 4, 3));
    QVERIFY(!hasTag(session, 0, 3)); // not against the direction
}

void TestCompanions::aCircleOfFriendsHearsItOnce()
{
    Scene scene = rowOf(4);
    relate(scene, {{1, 2, 1.0F, kFriends}, {2, 3, 1.0F, kFriends}, {1, 3, 1.0F, kFriends}});
    scene.rules = {onEvent("news", {tagWith(3)}), onEvent("other", {tagWith(4)})};
    scene.rules.back().id = 2;
    Session session(scene);
    session.send("news", 1.0F, {1});
    run(session, 10);
    session.send("other", 1.0F, {2});
    run(session, 20 * kStepsPerSecond);
    QCOMPARE(session.rules().count(1), std::uint64_t{3});
    QCOMPARE(session.rules().count(2), std::uint64_t{3});
    session.send("news", 1.0F, {3}); // another call
    run(session, 5 * kStepsPerSecond);
    QCOMPARE(session.rules().count(1), std::uint64_t{6});
    QVERIFY(!hasTag(session, 3, 3));
}

void TestCompanions::rulesReachThoseRelated()
{
    Scene scene = rowOf(4);
    relate(scene, {{1, 3, 1.0F, kFamily}, {4, 1, 1.0F, kLeader}});
    actions::SendEvent tell;
    tell.event = "psst";
    tell.reach = EventReach::Related;
    tell.relation = kFamily;
    actions::SendEvent all = tell;
    all.event = "all";
    all.relation = 0;
    scene.rules = {onEvent("start", {tell, all}), onEvent("psst", {tagWith(3)}),
                   onEvent("all", {tagWith(4)})};
    scene.rules[1].id = 2;
    scene.rules[2].id = 3;
    Session session(scene);
    session.send("start", 1.0F, {1});
    run(session, 6);
    QVERIFY(hasTag(session, 2, 3) && !hasTag(session, 1, 3) && !hasTag(session, 3, 3));
    QVERIFY(hasTag(session, 3, 4) && !hasTag(session, 0, 4) && !hasTag(session, 1, 4));
}

void TestCompanions::conditionsCountThem()
{
    Scene scene = rowOf(4);
    relate(scene, {{1, 2, 1.0F, kFriends}, {1, 3, 1.0F, kFriends}, {3, 4, 1.0F, kFamily}});
    kindOf(scene, kFriends).passesEvents = false;
    Rule rule = onEvent("ask", {tagWith(3)});
    rule.conditions = {conditions::Related{kFriends, Comparison::More, 1.0F}};
    Rule any = onEvent("ask", {tagWith(4)});
    any.id = 2;
    any.conditions = {conditions::Related{0, Comparison::Equal, 2.0F}};
    scene.rules = {rule, any};
    Session session(scene);
    session.send("ask", 1.0F, {1, 2, 3, 4});
    run(session, 4);
    for (std::uint32_t agent = 0; agent < 4; ++agent) {
        QCOMPARE(hasTag(session, agent, 3), agent == 0);
        QCOMPARE(hasTag(session, agent, 4), agent == 2); // the first one has a rule already
    }
}

void TestCompanions::rulesHearOfWhatTheyDo()
{
    Scene scene = rowOf(3);
    addStreet(scene);
    relate(scene, {{1, 2, 1.0F, kFamily}});
    kindOf(scene, kFamily).facesEachOther = false;
    triggers::RelatedDid hears;
    hears.relation = kFamily;
    hears.deed = RelatedDeed::Hears;
    hears.event = "bell";
    triggers::RelatedDid arrives;
    arrives.place = 2;
    triggers::RelatedDid leaves;
    leaves.deed = RelatedDeed::Leaves;
    leaves.place = 1;
    actions::GoToPlace go;
    go.place = 2;
    scene.rules = {when(Trigger(hears), {tagWith(3)}, 1), when(Trigger(arrives), {tagWith(4)}, 2),
                   when(Trigger(leaves), {tagWith(5)}, 3), onEvent("go", {go})};
    scene.rules.back().id = 4;
    Session session(scene);
    session.send("bell", 1.0F, {1});
    run(session, 4);
    QVERIFY(hasTag(session, 1, 3) && !hasTag(session, 0, 3) && !hasTag(session, 2, 3));
    session.send("go", 1.0F, {1});
    run(session, 5 * kStepsPerSecond);
    QVERIFY(hasTag(session, 1, 5) && !hasTag(session, 0, 5) && !hasTag(session, 1, 4));
    run(session, 40 * kStepsPerSecond);
    QVERIFY(hasTag(session, 1, 4) && !hasTag(session, 2, 4));
}

void TestCompanions::aimsAreThoseRelated()
{
    Scene scene = rowOf(4);
    putAt(scene, 4, {0.0F, 0.0F, 12.0F});
    relate(scene, {{1, 4, 1.0F, kFamily}});
    actions::LookAt look;
    look.aim = ActionAim::Related;
    look.relation = kFamily;
    look.seconds = 0.0F;
    actions::GoToPerson meet;
    meet.aim = ActionAim::Related;
    meet.metres = 1.0F;
    meet.seconds = 30.0F;
    scene.rules = {onEvent("look", {look}), onEvent("meet", {meet})};
    scene.rules.back().id = 2;
    Session session(scene);
    session.send("look", 1.0F, {2}); // he has nobody
    session.send("look", 1.0F, {4});
    run(session, 2 * kStepsPerSecond);
    QVERIFY(std::fabs(headingOf(session, 1)) < 0.01F);
    QVERIFY(std::fabs(std::fabs(headingOf(session, 3)) - 3.14159F) < 0.1F);
    session.send("meet", 1.0F, {1});
    run(session, 15 * kStepsPerSecond);
    QVERIFY2(apart(session, 0, 3) < 2.0F, qPrintable(QString::number(apart(session, 0, 3))));
}

void TestCompanions::editsAreFollowed()
{
    Scene scene = rowOf(3);
    addStreet(scene);
    walkAlong(scene, {1}, 1);
    Session session(scene);
    run(session, 10);
    relate(scene, {{1, 2, 1.0F, kLeader}, {1, 3, 1.0F, kLeader}});
    session.adopt(scene);
    run(session, 8 * kStepsPerSecond);
    QVERIFY(placeOf(session, 1).z > 4.0F && placeOf(session, 2).z > 4.0F);
    scene.relations.remove(std::vector<Relation>{{1, 2, 1.0F, kLeader}});
    scene.population.remove(std::vector<IndividualId>{1}); // with what he led
    scene.relations.remove(scene.relations.all());
    session.adopt(scene);
    run(session, 4 * kStepsPerSecond);
    const glm::vec3 rest = placeOf(session, 0);
    run(session, 2 * kStepsPerSecond);
    QVERIFY2(glm::distance(rest, placeOf(session, 0)) < 0.3F, "nobody is left to follow");
}

void TestCompanions::theSameForAnyNumberOfRuns()
{
    const auto runOnce = [] {
        Scene scene = rowOf(40);
        addStreet(scene);
        walkAlong(scene, {1, 5, 9}, 1);
        for (IndividualId id = 2; id <= 40; ++id) {
            relate(scene, {{id - 1, id, 1.0F, static_cast<RelationKindId>(1 + id % 5)}});
        }
        scene.rules = {onEvent("go", {tagWith(3)})};
        Session session(scene);
        session.send("go", 1.0F, {1, 20});
        run(session, 10 * kStepsPerSecond);
        const auto frame = session.frame();
        const auto at = frame->population.column(columns::position);
        const auto heading = frame->population.column(columns::heading);
        return std::pair(std::vector<glm::vec3>(at.begin(), at.end()),
                         std::vector<float>(heading.begin(), heading.end()));
    };
    QVERIFY(runOnce() == runOnce());
}

CROWD_TEST(TestCompanions)
#include "tst_Companions.moc"
