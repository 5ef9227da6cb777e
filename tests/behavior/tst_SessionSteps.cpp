// SPDX-License-Identifier: MIT
#include <cmath>

#include <QtTest/QTest>

#include "model/base/Parallel.h"
#include "tests/behavior/Actors.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

/// One who walks 12 m along Z as soon as it begins, then claps, then is tagged.
model::Scene walkAndClap(std::uint32_t stepsPerSecond)
{
    model::Scene scene = rowOf(1);
    scene.stepsPerSecond = stepsPerSecond;
    scene.places = {{1, "there", {0.0F, 0.0F, 12.0F}, 0.05F}};
    actions::GoToPlace go;
    go.place = 1;
    actions::PlayClip clap;
    clap.clips = {{"clap", 1.0F}};
    actions::AddTag mark;
    Rule rule = onEvent("", {go, clap, mark});
    rule.trigger = triggers::Start();
    scene.rules = {rule};
    return scene;
}

double secondsUntilMarked(const model::Scene& scene)
{
    Session session(scene);
    while (session.rules().tags(0) == 0 && session.seconds() < 30.0) {
        session.step();
    }
    return session.seconds();
}

void addRates()
{
    QTest::addColumn<std::uint32_t>("rate");
    for (const std::uint32_t rate : model::kStepRates) {
        QTest::addRow("1/%u s", rate) << rate;
    }
}

} // namespace

class TestSessionSteps : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void thingsTakeAsLongWithFinerSteps_data();
    void thingsTakeAsLongWithFinerSteps();
    void walkersAreAsFast_data();
    void walkersAreAsFast();
    void isTheSameForAnyNumberOfThreads_data();
    void isTheSameForAnyNumberOfThreads();
};

void TestSessionSteps::thingsTakeAsLongWithFinerSteps_data()
{
    addRates();
}

void TestSessionSteps::thingsTakeAsLongWithFinerSteps()
{
    QFETCH(const std::uint32_t, rate);
    const double usual = secondsUntilMarked(walkAndClap(30));
    const double seconds = secondsUntilMarked(walkAndClap(rate));
    QVERIFY(usual > 9.0 && usual < 14.0);
    QVERIFY2(std::abs(seconds - usual) < 0.2, QByteArray::number(seconds - usual));
}

void TestSessionSteps::walkersAreAsFast_data()
{
    addRates();
}

void TestSessionSteps::walkersAreAsFast()
{
    QFETCH(const std::uint32_t, rate);
    model::Scene scene = walkAndClap(rate);
    scene.population.setValues<float>(
        model::columns::walkSpeed, std::vector<model::IndividualId>{1}, std::vector<float>{1.5F});
    Session session(scene);
    run(session, static_cast<int>(2 * rate));
    const glm::vec3 before = placeOf(session, 0);
    run(session, static_cast<int>(4 * rate));
    const float speed = (placeOf(session, 0).z - before.z) / 4.0F;
    QVERIFY2(std::fabs(speed - 1.5F) < 0.03F, QByteArray::number(static_cast<double>(speed)));
    QCOMPARE(session.seconds(), 6.0);
}

void TestSessionSteps::isTheSameForAnyNumberOfThreads_data()
{
    addRates();
}

void TestSessionSteps::isTheSameForAnyNumberOfThreads()
{
    QFETCH(const std::uint32_t, rate);
    model::Scene scene = rowOf(200);
    scene.stepsPerSecond = rate;
    actions::Flee flee;
    flee.metres = 6.0F;
    scene.rules = {onEvent("run", {flee})};
    std::vector<model::Population> ends;
    for (const int threads : {1, 3}) {
        const model::ThreadLimit limit(threads);
        Session session(scene);
        const auto ids = scene.population.ids();
        session.send("run", 0.0F, {ids.begin(), ids.end()});
        run(session, 90);
        ends.push_back(session.frame()->population);
    }
    QVERIFY(ends[0] == ends[1]);
}

CROWD_TEST(TestSessionSteps)
#include "tst_SessionSteps.moc"
