// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <QtTest/QTest>

#include "model/rules/RuleSets.h"
#include "tests/behavior/RuleScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;
using model::Condition;

class TestPlaceRooms : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aFullPlaceIsFull();
    void roomThatIsNotStatedIsThatOfTheArea_data();
    void roomThatIsNotStatedIsThatOfTheArea();
    void freePlacesAreTakenByOneEach();
    void aQueueMovesUpAndIsServed();
    void theNearestIsThatWithTheShortestWay();
};

void TestPlaceRooms::aFullPlaceIsFull()
{
    model::Scene scene = rowOf(5); // at x = 0, 2, 4, 6, 8
    scene.places = {{1, "lift", {2.0F, 0.0F, 0.0F}, 2.5F}, {2, "hall", {6.0F, 0.0F, 0.0F}, 2.5F}};
    scene.places[0].capacity = 3;
    scene.places[1].capacity = 4;
    std::vector<Rule> rules;
    const auto ask = [&](const Condition& condition, std::uint8_t tag) {
        Rule rule = onEvent("ask", {tagWith(tag)});
        rule.id = tag;
        rule.meeting = model::RuleMeeting::Queue;
        rule.conditions = {condition};
        rules.push_back(rule);
    };
    ask(conditions::IsFull{1}, 1);
    ask(conditions::IsFull{2}, 2);
    ask(conditions::PeopleIn{1, model::Comparison::Equal, 3.0F}, 3);
    ask(conditions::PeopleIn{2, model::Comparison::Equal, 2.0F}, 4);
    scene.rules = rules;
    Session session(scene);
    session.send("ask", 0.0F, {1});
    run(session, 5);
    QVERIFY(hasTag(session, 0, 1) && !hasTag(session, 0, 2));
    QVERIFY(hasTag(session, 0, 3) && !hasTag(session, 0, 4)); // three are in the hall too
}

/// Two on a square metre, but one where people line up.
void TestPlaceRooms::roomThatIsNotStatedIsThatOfTheArea_data()
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

void TestPlaceRooms::roomThatIsNotStatedIsThatOfTheArea()
{
    QFETCH(const int, choice);
    QFETCH(const std::uint32_t, capacity);
    QFETCH(const std::size_t, inside);
    model::Scene scene = rowOf(9);
    scene.places = {{1, "hall", {8.0F, 0.0F, 6.0F}, 1.0F}};
    scene.places[0].capacity = capacity;
    actions::GoToPlace go;
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

void TestPlaceRooms::freePlacesAreTakenByOneEach()
{
    model::Scene scene = rowOf(6);
    addLine(scene, 4);
    actions::GoToPlace go;
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
    scene.rules.push_back(onEvent("home", {actions::LeaveScene()}));
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

void TestPlaceRooms::aQueueMovesUpAndIsServed()
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
    QCOMPARE(session.rules().count(1), std::uint64_t{4 + 3 + 2 + 1});
    QCOMPARE(session.rules().takeLog().size(), std::size_t{5 + 5 + 10});
}

/// Beside a place behind a wall, the way to which is long.
void TestPlaceRooms::theNearestIsThatWithTheShortestWay()
{
    behavior::PlaceRooms rooms;
    std::vector<model::Place> places;
    for (const float x : {4.0F, 6.0F, 9.0F, 30.0F, 60.0F}) {
        model::Place exit{static_cast<model::PlaceId>(places.size() + 1), "exit", {x, 0.0F, 0.0F}};
        exit.role = model::PlaceRole::Exit;
        places.push_back(exit);
    }
    rooms.setPlaces(places, {});
    const behavior::PlaceWish wish{model::PlaceChoice::Nearest, 0, 0, model::PlaceRole::Exit};
    const auto chosen = [&](const std::vector<float>& ways, std::vector<model::PlaceId>& asked) {
        asked.clear();
        return rooms.choose(wish, glm::vec3(0.0F), 0, [&](const model::Place& place) {
            asked.push_back(place.id);
            return ways[place.id - 1];
        });
    };
    constexpr float kNone = std::numeric_limits<float>::infinity();
    std::vector<model::PlaceId> asked;
    QCOMPARE(chosen({40.0F, 50.0F, 12.0F, 30.0F, 60.0F}, asked), std::optional(model::PlaceId{3}));
    QCOMPARE(asked, (std::vector<model::PlaceId>{1, 2, 3})); // no other can be nearer
    QCOMPARE(chosen({kNone, kNone, kNone, 80.0F, 90.0F}, asked), std::optional(model::PlaceId{4}));
    QCOMPARE(chosen({kNone, kNone, kNone, kNone, kNone}, asked), std::optional(model::PlaceId{1}));
    QCOMPARE(rooms.choose(wish, glm::vec3(0.0F), 0), std::optional(model::PlaceId{1}));
    rooms.setPlaces({places[3]}, {});
    QCOMPARE(chosen({kNone, kNone, kNone, kNone}, asked), std::optional(model::PlaceId{4}));
    QVERIFY(asked.empty()); // there is no choice
}

CROWD_TEST(TestPlaceRooms)
#include "tst_PlaceRooms.moc"
