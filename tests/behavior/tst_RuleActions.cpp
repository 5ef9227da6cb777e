// SPDX-License-Identifier: MIT
#include <set>

#include <QtTest/QTest>

#include "model/base/Parallel.h"
#include "model/scene/RuleSets.h"
#include "tests/behavior/Actors.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;
using model::Condition;
using model::ConditionKind;
using model::TriggerKind;

namespace {

Action tagWith(std::uint8_t tag)
{
    Action made = action(ActionKind::AddTag);
    made.tag = tag;
    return made;
}

Action sitDown()
{
    Action made = action(ActionKind::SitDown);
    made.metres = 0.0F; // however far
    return made;
}

Rule when(TriggerKind kind, std::vector<Action> actions, model::RuleId id = 1)
{
    Rule rule;
    rule.id = id;
    rule.name = "when";
    rule.trigger.kind = kind;
    rule.actions = std::move(actions);
    return rule;
}

bool hasTag(Session& session, std::uint32_t agent, std::uint8_t tag)
{
    return (session.rules().tags(agent) >> tag & 1U) != 0;
}

/// Four seats in a row at z = 6, 0.6 m apart, each 0.45 m high and facing -Z.
void addSeats(model::Scene& scene, int count = 4)
{
    auto asset = std::make_shared<model::StageAsset>();
    for (int i = 0; i < count; ++i) {
        model::Seat seat;
        seat.position = {0.6F * static_cast<float>(i), 0.0F, 6.0F};
        seat.headingRadians = 3.14159265F;
        seat.height = 0.45F;
        asset->seats.push_back(seat);
    }
    model::StageEntry entry;
    entry.id = 1;
    entry.asset = asset;
    scene.stages.push_back(entry);
}

model::SeatId shownSeat(const Session& session, std::size_t row)
{
    return session.frame()->population.column(model::columns::seat)[row];
}

/// Places 1.5 m apart along Z from z = 4, and a path "line" over them, the nearest in front.
void addLine(model::Scene& scene, int places)
{
    model::Path line{1, "line", model::PathKind::Simple, {}};
    for (int i = 0; i < places; ++i) {
        const auto id = static_cast<model::PlaceId>(i + 1);
        scene.places.push_back(
            {id, "spot", {0.0F, 0.0F, 4.0F + 1.5F * static_cast<float>(i)}, 0.2F});
        line.places.push_back(id);
    }
    scene.paths.push_back(line);
}

void letWalk(model::Scene& scene, model::PathId path)
{
    const auto ids = scene.population.ids();
    const std::vector<model::IndividualId> all(ids.begin(), ids.end());
    const std::vector<model::PathId> paths(all.size(), path);
    scene.population.setValues<model::PathId>(model::columns::path, all, paths);
}

} // namespace

class TestRuleActions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void waitingForAnEventEndsWithItOrInTime();
    void ownNumbersBeginDrawnAndAreChanged();
    void numbersSurviveEdits();
    void thePayloadCanBeAskedFor();
    void aSpeedLimitIsNoticedOnceEachTime();
    void standingTooLongIsNoticedOnce();
    void aRuleYieldsAsItSays_data();
    void aRuleYieldsAsItSays();
    void whoArrivesIsFreeForTheRuleThatWaitsForIt();
    void whoLeftComesBackWhereARuleSays();
    void leavingAtAPlaceGoesThereFirst();
    void aFullPlaceIsFull();
    void roomThatIsNotStatedIsThatOfTheArea_data();
    void roomThatIsNotStatedIsThatOfTheArea();
    void freePlacesAreTakenByOneEach();
    void aQueueMovesUpAndIsServed();
    void peopleSitOnTheNearestFreeSeats();
    void standingUpFreesTheSeat();
    void walkingOffFreesTheSeat();
    void whoCannotReachASeatGivesUp();
    void aWalkingStyleIsKept();
    void everythingIsTheSameForAnyNumberOfThreads();
    void whatIsGoneIsSaidByName_data();
    void whatIsGoneIsSaidByName();
};

void TestRuleActions::waitingForAnEventEndsWithItOrInTime()
{
    model::Scene scene = rowOf(3);
    Action wait = action(ActionKind::WaitForEvent);
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

void TestRuleActions::ownNumbersBeginDrawnAndAreChanged()
{
    model::Scene scene = rowOf(200);
    scene.numbers = {{3, "patience", 2.0F, 4.0F}};
    Action less = action(ActionKind::AddToNumber);
    less.number = 3;
    less.value = -1.0F;
    Rule lose = onEvent("push", {less});
    Action set = action(ActionKind::SetNumber);
    set.number = 3;
    set.value = 10.0F;
    Rule angry = onEvent("push", {tagWith(5), set});
    angry.id = 2;
    angry.meeting = model::RuleMeeting::Queue;
    Condition low;
    low.kind = ConditionKind::Number;
    low.number = 3;
    low.comparison = model::Comparison::Less;
    low.value = 2.5F;
    angry.conditions = {low};
    scene.rules = {lose, angry};
    Session session(scene);
    float least = 10.0F;
    float most = 0.0F;
    std::vector<float> first;
    for (std::uint32_t agent = 0; agent < 200; ++agent) {
        first.push_back(session.rules().number(agent, 3));
        least = std::min(least, first.back());
        most = std::max(most, first.back());
    }
    QVERIFY(least >= 2.0F && least < 2.2F && most <= 4.0F && most > 3.8F);
    QCOMPARE(session.rules().number(0, 9), 0.0F);
    const auto ids = scene.population.ids();
    session.send("push", 0.0F, {ids.begin(), ids.end()});
    run(session, 3);
    for (std::uint32_t agent = 0; agent < 200; ++agent) {
        const bool isAngry = first[agent] < 2.5F;
        QCOMPARE(hasTag(session, agent, 5), isAngry);
        QCOMPARE(session.rules().number(agent, 3), isAngry ? 10.0F : first[agent] - 1.0F);
    }
}

void TestRuleActions::numbersSurviveEdits()
{
    model::Scene scene = rowOf(2);
    scene.numbers = {{1, "hunger", 0.0F, 0.0F}, {2, "money", 5.0F, 5.0F}};
    Action more = action(ActionKind::AddToNumber);
    more.number = 1;
    more.value = 3.0F;
    scene.rules = {onEvent("later", {more})};
    Session session(scene);
    session.send("later", 0.0F, {1});
    run(session, 2);
    QCOMPARE(session.rules().number(0, 1), 3.0F);
    scene.numbers = {{1, "appetite", 0.0F, 0.0F}, {4, "fear", 1.0F, 1.0F}};
    session.adopt(scene);
    QCOMPARE(session.rules().number(0, 1), 3.0F);
    QCOMPARE(session.rules().number(1, 1), 0.0F);
    QCOMPARE(session.rules().number(0, 2), 0.0F);
    QCOMPARE(session.rules().number(0, 4), 1.0F);
    const std::vector<model::IndividualId> gone{1};
    (void)scene.population.remove(gone);
    auto rows = model::IndividualRows::withDefaults({7});
    rows.column(model::columns::templateId)[0] = 1;
    scene.population.add(rows);
    session.adopt(scene);
    run(session, 1);
    QCOMPARE(session.rules().number(1, 4), 1.0F);
}

void TestRuleActions::thePayloadCanBeAskedFor()
{
    model::Scene scene = rowOf(2);
    Rule loud = onEvent("bang", {tagWith(1)});
    Condition above;
    above.kind = ConditionKind::Payload;
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

void TestRuleActions::aSpeedLimitIsNoticedOnceEachTime()
{
    model::Scene scene = rowOf(1);
    scene.places = {{1, "far", {0.0F, 0.0F, 80.0F}, 0.1F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1}}};
    letWalk(scene, 1);
    Rule fast = when(TriggerKind::SpeedLimit, {tagWith(1)});
    fast.trigger.metresPerSecond = 2.0F;
    Rule slow = when(TriggerKind::SpeedLimit, {tagWith(2)}, 2);
    slow.trigger.metresPerSecond = 0.5F;
    slow.trigger.isAbove = false;
    Action speed = action(ActionKind::SetSpeed);
    Rule set = onEvent("speed", {speed});
    set.id = 3;
    Rule stop = onEvent("stop", {action(ActionKind::Stop)});
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

void TestRuleActions::standingTooLongIsNoticedOnce()
{
    model::Scene scene = rowOf(1);
    scene.places = {{1, "there", {0.0F, 0.0F, 5.0F}, 0.1F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1}}};
    letWalk(scene, 1);
    Rule bored = when(TriggerKind::Waited, {tagWith(1)});
    bored.trigger.seconds = 3.0F;
    scene.rules = {bored};
    Session session(scene);
    run(session, 150); // he has just arrived
    QCOMPARE(session.rules().count(1), std::uint64_t{0});
    run(session, 240);
    QCOMPARE(session.rules().count(1), std::uint64_t{1});
    run(session, 240);
    QCOMPARE(session.rules().count(1), std::uint64_t{1});
}

void TestRuleActions::aRuleYieldsAsItSays_data()
{
    QTest::addColumn<int>("yields");
    QTest::addColumn<bool>("isBrokenByAbove");
    QTest::addColumn<bool>("isBrokenByBelow");
    QTest::newRow("to those further up")
        << static_cast<int>(model::RuleYield::FurtherUp) << true << false;
    QTest::newRow("to anybody") << static_cast<int>(model::RuleYield::Anybody) << true << true;
    QTest::newRow("to nobody") << static_cast<int>(model::RuleYield::Nobody) << false << false;
}

void TestRuleActions::aRuleYieldsAsItSays()
{
    QFETCH(const int, yields);
    QFETCH(const bool, isBrokenByAbove);
    QFETCH(const bool, isBrokenByBelow);
    for (const bool isAbove : {true, false}) {
        model::Scene scene = rowOf(1);
        Action wait = action(ActionKind::Wait);
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

void TestRuleActions::whoArrivesIsFreeForTheRuleThatWaitsForIt()
{
    model::Scene scene = rowOf(1);
    scene.places = {{1, "desk", {0.0F, 0.0F, 5.0F}, 0.3F}};
    Action go = action(ActionKind::GoToPlace);
    go.place = 1;
    Rule arrived = when(TriggerKind::Arrived, {tagWith(3)}, 2);
    arrived.trigger.place = 1;
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

void TestRuleActions::whoLeftComesBackWhereARuleSays()
{
    model::Scene scene = rowOf(2);
    scene.places = {{1, "gate", {0.0F, 0.0F, -20.0F}, 1.0F}, {2, "end", {0.0F, 0.0F, 9.0F}, 0.2F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {2}}};
    Action wait = action(ActionKind::Wait);
    wait.seconds = 2.0F;
    Action appear = action(ActionKind::Appear);
    appear.place = 1;
    Action follow = action(ActionKind::FollowPath);
    follow.path = 1;
    Rule gone = onEvent("out", {action(ActionKind::LeaveScene)});
    Rule late = onEvent("late", {action(ActionKind::LeaveScene), wait, appear, follow});
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
    Action leave = action(ActionKind::LeaveScene);
    leave.place = 1;
    scene.rules = {onEvent("home", {leave})};
    Session session(scene);
    session.send("home", 0.0F, {1});
    run(session, 45);
    QVERIFY(placeOf(session, 0).z > 0.5F && placeOf(session, 0).y == 0.0F);
    run(session, 240);
    QVERIFY(placeOf(session, 0).y < -1000.0F);
}

void TestRuleActions::aFullPlaceIsFull()
{
    model::Scene scene = rowOf(5); // at x = 0, 2, 4, 6, 8
    scene.places = {{1, "lift", {2.0F, 0.0F, 0.0F}, 2.5F}, {2, "hall", {6.0F, 0.0F, 0.0F}, 2.5F}};
    scene.places[0].capacity = 3;
    scene.places[1].capacity = 4;
    std::vector<Rule> rules;
    const auto ask = [&](ConditionKind kind, model::PlaceId place, float value, std::uint8_t tag) {
        Condition condition;
        condition.kind = kind;
        condition.place = place;
        condition.comparison = model::Comparison::Equal;
        condition.value = value;
        Rule rule = onEvent("ask", {tagWith(tag)});
        rule.id = tag;
        rule.meeting = model::RuleMeeting::Queue;
        rule.conditions = {condition};
        rules.push_back(rule);
    };
    ask(ConditionKind::IsFull, 1, 0.0F, 1);
    ask(ConditionKind::IsFull, 2, 0.0F, 2);
    ask(ConditionKind::PeopleIn, 1, 3.0F, 3);
    ask(ConditionKind::PeopleIn, 2, 2.0F, 4);
    scene.rules = rules;
    Session session(scene);
    session.send("ask", 0.0F, {1});
    run(session, 5);
    QVERIFY(hasTag(session, 0, 1) && !hasTag(session, 0, 2));
    QVERIFY(hasTag(session, 0, 3) && !hasTag(session, 0, 4)); // three are in the hall too
}

/// Two on a square metre, but one where people line up.
void TestRuleActions::roomThatIsNotStatedIsThatOfTheArea_data()
{
    QTest::addColumn<int>("choice");
    QTest::addColumn<std::uint32_t>("capacity");
    QTest::addColumn<std::size_t>("inside");
    const auto row = [](const char* name, model::PlaceChoice choice, std::uint32_t capacity,
                        std::size_t inside) {
        QTest::newRow(name) << static_cast<int>(choice) << capacity << inside;
    };
    row("a circle of 1 m", model::PlaceChoice::NearestFree, 0, 6);
    row("one that says two", model::PlaceChoice::NearestFree, 2, 2);
    row("in a line", model::PlaceChoice::FirstFree, 0, 1);
    row("in a line of pairs", model::PlaceChoice::FirstFree, 2, 2);
}

void TestRuleActions::roomThatIsNotStatedIsThatOfTheArea()
{
    QFETCH(const int, choice);
    QFETCH(const std::uint32_t, capacity);
    QFETCH(const std::size_t, inside);
    model::Scene scene = rowOf(9);
    scene.places = {{1, "hall", {8.0F, 0.0F, 6.0F}, 1.0F}};
    scene.places[0].capacity = capacity;
    Action go = action(ActionKind::GoToPlace);
    go.choice = static_cast<model::PlaceChoice>(choice);
    scene.rules = {onEvent("in", {go})};
    Session session(scene);
    session.send("in", 0.0F, {1, 2, 3, 4, 5, 6, 7, 8, 9});
    run(session, 600);
    std::size_t there = 0;
    for (std::size_t row = 0; row < 9; ++row) {
        there += placeOf(session, row).z > 4.0F ? 1 : 0;
    }
    QCOMPARE(there, inside);
}

void TestRuleActions::freePlacesAreTakenByOneEach()
{
    model::Scene scene = rowOf(6);
    addLine(scene, 4);
    Action go = action(ActionKind::GoToPlace);
    go.choice = model::PlaceChoice::NearestFree;
    go.path = 1;
    scene.rules = {onEvent("go", {go, tagWith(1)})};
    Session session(scene);
    session.send("go", 0.0F, {1, 2, 3, 4, 5, 6});
    run(session, 600);
    std::set<int> places;
    int there = 0;
    for (std::uint32_t agent = 0; agent < 6; ++agent) {
        const glm::vec3 at = placeOf(session, agent);
        const float spot = (at.z - 4.0F) / 1.5F;
        if (hasTag(session, agent, 1)) {
            ++there;
            places.insert(static_cast<int>(std::lround(spot)));
            QVERIFY2(std::abs(at.x) < 1.0F, QByteArray::number(at.x));
        }
    }
    QCOMPARE(there, 4);
    QCOMPARE(places.size(), std::size_t{4});
    // One goes home: one of those who still wait takes his place.
    scene.rules.push_back(onEvent("home", {action(ActionKind::LeaveScene)}));
    scene.rules.back().id = 2;
    session.adopt(scene);
    for (std::uint32_t agent = 0; agent < 6; ++agent) {
        if (hasTag(session, agent, 1)) {
            session.send("home", 0.0F, {agent + 1});
            break;
        }
    }
    run(session, 400);
    there = 0;
    for (std::uint32_t agent = 0; agent < 6; ++agent) {
        there += hasTag(session, agent, 1) ? 1 : 0;
    }
    QCOMPARE(there, 5);
}

void TestRuleActions::aQueueMovesUpAndIsServed()
{
    model::Scene scene = rowOf(5);
    addLine(scene, 6);
    scene.rules = model::rulesOf(model::RuleSet::Queue, scene);
    model::giveIds(scene.rules, scene);
    Session session(scene);
    session.send("queue", 0.0F, {1, 2, 3, 4, 5});
    std::vector<int> order;
    float nearest = 10.0F;
    for (int step = 0; step < 30 * 90 && order.size() < 5; ++step) {
        session.step();
        for (std::uint32_t a = 0; a < 5; ++a) {
            const bool isGone = placeOf(session, a).y < -1000.0F;
            if (isGone && std::ranges::find(order, static_cast<int>(a)) == order.end()) {
                order.push_back(static_cast<int>(a));
            }
            for (std::uint32_t b = 0; b < a && !isGone; ++b) {
                nearest =
                    std::min(nearest, glm::distance(placeOf(session, a), placeOf(session, b)));
            }
        }
    }
    QCOMPARE(order.size(), std::size_t{5});
    QVERIFY2(nearest > 0.35F, QByteArray::number(nearest));
    QVERIFY(session.rules().problems().empty());
    // Each time that one has been served all behind him move up by one, and nothing else is logged.
    QCOMPARE(session.rules().count(3), std::uint64_t{4 + 3 + 2 + 1});
    QCOMPARE(session.rules().takeLog().size(), std::size_t{5 + 5 + 10});
}

void TestRuleActions::peopleSitOnTheNearestFreeSeats()
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
    Action near = sitDown();
    near.metres = 2.0F;
    scene.rules = {onEvent("sit", {near})};
    Session other(scene);
    other.send("sit", 0.0F, {1});
    run(other, 60);
    QVERIFY(placeOf(other, 0).z < 0.2F);
    // None was left for the third: on to what comes next, where he stands.
    QCOMPARE(shownSeat(session, 2), model::kNoSeat);
    QVERIFY(hasTag(session, 2, 1) && placeOf(session, 2).z < 0.2F);
    QVERIFY(scene.population.column(model::columns::seat)[0] == model::kNoSeat);
}

void TestRuleActions::standingUpFreesTheSeat()
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
    Action away = action(ActionKind::Flee);
    away.metres = 5.0F;
    Rule stand = onEvent("stand", {action(ActionKind::StandUp), tagWith(1), away});
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

void TestRuleActions::walkingOffFreesTheSeat()
{
    model::Scene scene = rowOf(2);
    addSeats(scene, 1);
    scene.places = {{1, "door", {0.0F, 0.0F, 12.0F}, 0.2F}};
    Action go = action(ActionKind::GoToPlace);
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

void TestRuleActions::whoCannotReachASeatGivesUp()
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
    Action add = action(ActionKind::AddToNumber);
    add.number = 1;
    add.value = -0.5F;
    Rule sit = when(TriggerKind::Every, {add, sitDown()});
    sit.trigger.seconds = 2.0F;
    Condition low;
    low.kind = ConditionKind::Number;
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
    QTest::addColumn<int>("kind");
    QTest::newRow("a place to go to") << static_cast<int>(ActionKind::GoToPlace);
    QTest::newRow("a place to appear at") << static_cast<int>(ActionKind::Appear);
    QTest::newRow("a place to leave at") << static_cast<int>(ActionKind::LeaveScene);
    QTest::newRow("a number to set") << static_cast<int>(ActionKind::SetNumber);
    QTest::newRow("a number to add to") << static_cast<int>(ActionKind::AddToNumber);
}

void TestRuleActions::whatIsGoneIsSaidByName()
{
    QFETCH(const int, kind);
    model::Scene scene = rowOf(1);
    Action lost = action(static_cast<ActionKind>(kind));
    lost.place = 77;
    lost.number = 77;
    scene.rules = {onEvent("lost", {lost, tagWith(1)})};
    Session session(scene);
    session.send("lost", 0.0F, {1});
    run(session, 3);
    QCOMPARE(session.rules().problems().size(), std::size_t{1});
    QVERIFY(session.rules().problems().front().text.find("\"lost\"") != std::string::npos);
    QVERIFY(hasTag(session, 0, 1)); // the session goes on
}

CROWD_TEST(TestRuleActions)
#include "tst_RuleActions.moc"
