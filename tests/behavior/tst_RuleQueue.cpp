// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>

#include <QtTest/QTest>

#include "model/base/Parallel.h"
#include "model/rules/RuleFlaws.h"
#include "model/rules/RuleSets.h"
#include "tests/behavior/RuleScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

std::vector<model::IndividualId> peopleFrom(model::IndividualId first, std::size_t count)
{
    std::vector<model::IndividualId> ids(count);
    std::iota(ids.begin(), ids.end(), first);
    return ids;
}

/// A line of eight places, and so many people a few metres beside it; the ready-made queue.
model::Scene queueScene(std::size_t people)
{
    model::Scene scene = rowOf(people);
    std::vector<glm::vec3> positions;
    for (std::size_t i = 0; i < people; ++i) {
        positions.emplace_back(-6.0F - 0.8F * static_cast<float>(i % 4), 0.0F,
                               4.0F + 1.1F * static_cast<float>(i / 4));
    }
    scene.population.setValues<glm::vec3>(model::columns::position, peopleFrom(1, people),
                                          positions);
    addLine(scene, 8);
    scene.rules = model::rulesOf(model::RuleSet::Queue, scene);
    model::giveIds(scene.rules, scene);
    return scene;
}

/// Ids in the order in which people are gone, until all are or so many steps have passed.
class Departures
{
public:
    void step(Session& session)
    {
        session.step();
        const auto frame = session.frame();
        const auto positions = frame->population.column(model::columns::position);
        for (std::size_t row = 0; row < positions.size(); ++row) {
            const model::IndividualId id = frame->population.ids()[row];
            if (positions[row].y < -1000.0F && std::ranges::find(m_order, id) == m_order.end()) {
                m_order.push_back(id);
            }
        }
    }
    [[nodiscard]] const std::vector<model::IndividualId>& order() const { return m_order; }

private:
    std::vector<model::IndividualId> m_order;
};

} // namespace

/// The ready-made queue: first come, first served.
class TestRuleQueue : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void moreThanHaveAPlaceAreServedInOrder();
    void whoComesLaterIsServedLater();
    void whoIsAddedLaterIsServedLater();
    void whoIsCalledAgainKeepsHisPlace();
    void whoStandsAroundTakesNoPlace();
    void whoGivesUpWaitingHoldsNobodyUp();
    void withoutAPathItWaitsForOne();
    void isTheSameForAnyNumberOfThreads();
};

void TestRuleQueue::moreThanHaveAPlaceAreServedInOrder()
{
    const model::Scene scene = queueScene(22);
    Session session(scene);
    session.send("queue", 0.0F, peopleFrom(1, 22));
    Departures departures;
    for (int step = 0; step < 30 * 400 && departures.order().size() < 22; ++step) {
        departures.step(session);
    }
    QCOMPARE(departures.order(), peopleFrom(1, 22));
    QVERIFY(session.problems().empty());
}

void TestRuleQueue::whoComesLaterIsServedLater()
{
    const model::Scene scene = queueScene(14);
    Session session(scene);
    session.send("queue", 0.0F, peopleFrom(5, 10));
    Departures departures;
    for (int step = 0; step < 60; ++step) {
        departures.step(session);
    }
    session.send("queue", 0.0F, peopleFrom(1, 4)); // with lower numbers, but later
    for (int step = 0; step < 30 * 300 && departures.order().size() < 14; ++step) {
        departures.step(session);
    }
    std::vector<model::IndividualId> expected = peopleFrom(5, 10);
    for (const model::IndividualId id : peopleFrom(1, 4)) {
        expected.push_back(id);
    }
    QCOMPARE(departures.order(), expected);
}

void TestRuleQueue::whoIsAddedLaterIsServedLater()
{
    model::Scene scene = queueScene(10);
    Session session(scene);
    session.send("queue", 0.0F, peopleFrom(1, 10));
    Departures departures;
    // Somebody is created each time that the place in front has just become free.
    model::IndividualId next = 11;
    for (int step = 0; step < 30 * 300 && departures.order().size() < 14; ++step) {
        const std::size_t gone = departures.order().size();
        departures.step(session);
        if (departures.order().size() > gone && next <= 14) {
            auto rows = model::IndividualRows::withDefaults({next});
            rows.column(model::columns::templateId)[0] = 1;
            rows.column(model::columns::position)[0] = {-2.0F, 0.0F, 4.0F}; // right at the front
            scene.population.add(rows);
            session.adopt(scene);
            session.send("queue", 0.0F, {next});
            ++next;
        }
    }
    QCOMPARE(departures.order(), peopleFrom(1, 14));
}

void TestRuleQueue::whoIsCalledAgainKeepsHisPlace()
{
    const model::Scene scene = queueScene(5);
    Session session(scene);
    session.send("queue", 0.0F, peopleFrom(1, 5));
    Departures departures;
    for (int step = 0; step < 30 * 200 && departures.order().size() < 5; ++step) {
        departures.step(session);
        if (step % 90 == 0) {
            session.send("queue", 0.0F, peopleFrom(1, 5));
        }
    }
    QCOMPARE(departures.order(), peopleFrom(1, 5));
}

void TestRuleQueue::whoStandsAroundTakesNoPlace()
{
    model::Scene scene = queueScene(3);
    scene.population.setValues<glm::vec3>(model::columns::position,
                                          std::vector<model::IndividualId>{3},
                                          std::vector<glm::vec3>{{0.0F, 0.0F, 5.5F}});
    Session session(scene); // the third stands in the second place and has no wish to queue
    session.send("queue", 0.0F, {1, 2});
    Departures departures;
    for (int step = 0; step < 30 * 100 && departures.order().size() < 2; ++step) {
        departures.step(session);
    }
    QCOMPARE(departures.order(), peopleFrom(1, 2));
}

void TestRuleQueue::whoGivesUpWaitingHoldsNobodyUp()
{
    model::Scene scene = queueScene(10);
    Rule home = onEvent("home", {actions::LeaveScene()});
    home.id = 9;
    scene.rules.insert(scene.rules.begin(), home);
    Session session(scene);
    session.send("queue", 0.0F, peopleFrom(1, 10));
    run(session, 60);
    session.send("home", 0.0F, {9}); // the first of those who have no place yet
    Departures departures;
    for (int step = 0; step < 30 * 250 && departures.order().size() < 10; ++step) {
        departures.step(session);
    }
    QCOMPARE(departures.order(), (std::vector<model::IndividualId>{9, 1, 2, 3, 4, 5, 6, 7, 8, 10}));
}

void TestRuleQueue::withoutAPathItWaitsForOne()
{
    model::Scene scene = rowOf(4);
    scene.places = {{1, "there", {0.0F, 0.0F, 6.0F}, 0.5F}};
    scene.rules = model::rulesOf(model::RuleSet::Queue, scene);
    model::giveIds(scene.rules, scene);
    for (const Rule& rule : scene.rules) {
        QVERIFY(model::gapOf(rule).has_value());
    }
    scene.rules.push_back(onEvent("go", {}));
    scene.rules.back().id = 8;
    actions::GoToPlace go;
    go.place = 1;
    scene.rules.back().actions = {go};
    Session session(scene);
    session.send("queue", 0.0F, peopleFrom(1, 2));
    session.send("go", 0.0F, {3});
    run(session, 600);
    QVERIFY(placeOf(session, 0).z < 0.1F);
    QVERIFY(placeOf(session, 2).y > -1.0F); // nobody is served at any place that he comes to
    QCOMPARE(session.problems().size(), std::size_t{3});
    for (const behavior::Problem& problem : session.problems()) {
        QVERIFY(problem.text.english().find("does nothing yet: choose a p") != std::string::npos);
    }
}

void TestRuleQueue::isTheSameForAnyNumberOfThreads()
{
    const model::Scene scene = queueScene(40);
    std::vector<model::Population> ends;
    for (const int threads : {1, 2, 4}) {
        const model::ThreadLimit limit(threads);
        Session session(scene);
        session.send("queue", 0.0F, peopleFrom(1, 40));
        run(session, 900);
        ends.push_back(session.frame()->population);
    }
    QVERIFY(ends[0] == ends[1]);
    QVERIFY(ends[0] == ends[2]);
}

CROWD_TEST(TestRuleQueue)
#include "tst_RuleQueue.moc"
