// SPDX-License-Identifier: MIT
#include <algorithm>

#include <QtTest/QTest>

#include "tests/behavior/RuleScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;
using model::Condition;

class TestRuleNumbers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void ownNumbersBeginDrawnAndAreChanged();
    void numbersSurviveEdits();
};

void TestRuleNumbers::ownNumbersBeginDrawnAndAreChanged()
{
    model::Scene scene = rowOf(200);
    scene.numbers = {{3, "patience", 2.0F, 4.0F}};
    actions::AddToNumber less;
    less.number = 3;
    less.value = -1.0F;
    Rule lose = onEvent("push", {less});
    actions::SetNumber set;
    set.number = 3;
    set.value = 10.0F;
    Rule angry = onEvent("push", {tagWith(5), set});
    angry.id = 2;
    angry.meeting = model::RuleMeeting::Queue;
    conditions::Number low;
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

void TestRuleNumbers::numbersSurviveEdits()
{
    model::Scene scene = rowOf(2);
    scene.numbers = {{1, "hunger", 0.0F, 0.0F}, {2, "money", 5.0F, 5.0F}};
    actions::AddToNumber more;
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

CROWD_TEST(TestRuleNumbers)
#include "tst_RuleNumbers.moc"
