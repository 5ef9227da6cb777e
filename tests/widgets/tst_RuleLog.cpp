// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "tests/program/Test.h"
#include "widgets/rules/RuleLog.h"

using namespace crowd;
using namespace crowd::widgets;

namespace {

/// "ping" with id 1 and "pong" with id 2.
model::Scene sceneWithRules()
{
    model::Scene scene;
    scene.rules.resize(2);
    scene.rules[0].id = 1;
    scene.rules[0].name = "ping";
    scene.rules[1].id = 2;
    scene.rules[1].name = "pong";
    return scene;
}

QStringList linesOf(const RuleLog& log, std::vector<model::IndividualId> only = {})
{
    return log.lines(sceneWithRules(), [&only](model::IndividualId who) {
        return only.empty() || std::ranges::find(only, who) != only.end();
    });
}

} // namespace

class TestRuleLog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatFiresOnceIsALine();
    void peopleOfOneBurstShareALine();
    void aCircleOfRulesHidesNothing();
    void theLogOfOnePersonIsExact();
    void aPauseBeginsAnotherLine();
    void theOldestIsForgotten();
};

void TestRuleLog::whatFiresOnceIsALine()
{
    RuleLog log;
    log.add({1.25, 1, 7});
    QCOMPARE(linesOf(log), QStringList{QStringLiteral("1.25 s · character 7 · ping")});
    log.add({1.5, 9, 7}); // deleted meanwhile
    QCOMPARE(linesOf(log).last(), QStringLiteral("1.50 s · character 7 · a deleted rule"));
    log.clear();
    QVERIFY(linesOf(log).isEmpty());
}

void TestRuleLog::peopleOfOneBurstShareALine()
{
    RuleLog log;
    log.add({1.0, 1, 9});
    log.add({1.5, 1, 3});
    QCOMPARE(linesOf(log), QStringList{QStringLiteral("1.00–1.50 s · characters 3, 9 · ping")});
    for (model::IndividualId who = 10; who < 13; ++who) {
        log.add({1.75, 1, who});
    }
    QCOMPARE(linesOf(log), QStringList{QStringLiteral("1.00–1.75 s · 5 characters · ping")});
    log.add({2.0, 1, 9});
    QCOMPARE(linesOf(log),
             QStringList{QStringLiteral("1.00–2.00 s · 5 characters · ping · 6 times in all")});
}

/// Thirty people who send themselves "ping" and "pong" in turn, and one event beside.
void TestRuleLog::aCircleOfRulesHidesNothing()
{
    RuleLog log;
    for (int step = 0; step < 24; ++step) {
        for (model::IndividualId who = 1; who <= 30; ++who) {
            log.add({step * 0.25, step % 2 == 0 ? 1U : 2U, who});
        }
        if (step == 10) {
            log.add({2.5, 9, 4});
        }
    }
    QCOMPARE(linesOf(log),
             (QStringList{QStringLiteral("0.00–5.50 s · 30 characters · ping · 12 times each"),
                          QStringLiteral("0.25–5.75 s · 30 characters · pong · 12 times each"),
                          QStringLiteral("2.50 s · character 4 · a deleted rule")}));
}

void TestRuleLog::theLogOfOnePersonIsExact()
{
    RuleLog log;
    for (model::IndividualId who = 1; who <= 30; ++who) {
        log.add({0.5 + who * 0.25, 1, who});
    }
    log.add({8.25, 1, 12});
    QCOMPARE(linesOf(log, {11}), QStringList{QStringLiteral("3.25 s · character 11 · ping")});
    QCOMPARE(linesOf(log, {12}),
             QStringList{QStringLiteral("3.50–8.25 s · character 12 · ping · 2 times")});
    QVERIFY(linesOf(log, {31}).isEmpty());
}

void TestRuleLog::aPauseBeginsAnotherLine()
{
    RuleLog log;
    log.add({4.0, 1, 7});
    log.add({8.0, 1, 7});
    QCOMPARE(linesOf(log), (QStringList{QStringLiteral("4.00 s · character 7 · ping"),
                                        QStringLiteral("8.00 s · character 7 · ping")}));
}

/// A line that still grows is kept, however long ago it began.
void TestRuleLog::theOldestIsForgotten()
{
    RuleLog log;
    for (int second = 0; second < 1000; ++second) {
        log.add({second * 2.0, 1, 7});
        for (int part = 0; part < 4; ++part) {
            log.add({second * 2.0 + part * 0.5, 2, 8});
        }
    }
    const QStringList lines = linesOf(log);
    QVERIFY(lines.size() > 100 && lines.size() < 500);
    QCOMPARE(lines.first(), QStringLiteral("0.00–1,999.50 s · character 8 · pong · 4000 times"));
    QCOMPARE(lines.last(), QStringLiteral("1,998.00 s · character 7 · ping"));
}

CROWD_TEST(TestRuleLog)
#include "tst_RuleLog.moc"
