// SPDX-License-Identifier: MIT
#include "behavior/session/SceneMotion.h"

#include <algorithm>
#include <vector>

#include <QtTest/QTest>

#include "behavior/session/MotionReader.h"
#include "behavior/session/RecordedSession.h"
#include "tests/behavior/StateScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;
using behavior::MotionCache;
using behavior::RecordedSession;
using behavior::SceneMotion;

namespace {

namespace motionKeys = model::columns;

/// People who walk ahead.
model::Scene strollScene()
{
    model::Scene scene = rowOf(6);
    scene.places = {{1, "far", {5.0F, 0.0F, 80.0F}, 8.0F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1}}};
    letWalk(scene, 1);
    return scene;
}

template<class T>
bool areSame(const model::CrowdFrame& a, const model::CrowdFrame& b, const model::ColumnKey<T>& key)
{
    return std::ranges::equal(a.population.column(key), b.population.column(key));
}

bool areSameMotion(const model::CrowdFrame& a, const model::CrowdFrame& b)
{
    return areSame(a, b, motionKeys::position) && areSame(a, b, motionKeys::heading) &&
           areSame(a, b, motionKeys::clip) && areSame(a, b, motionKeys::phase);
}

} // namespace

/// A scene at any time, without a window.
class TestSceneMotion : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void earlierTimesAreTheSame();
    void whatIsKeptIsNotSimulatedAgain();
    void theLastStepIsKeptOnce();
    void anEditChangesTheLastStep();
    void nothingIsKeptWithoutACache();
};

/// In whatever order they are asked for, at steps and between them.
void TestSceneMotion::earlierTimesAreTheSame()
{
    const model::Scene scene = strollScene();
    std::vector<double> times{0.0, 1.0 / 30.0, 0.1, 0.31, 0.5, 1.0, 1.01, 2.0};
    std::vector<model::CrowdFramePtr> forwards;
    SceneMotion motion(scene);
    for (const double time : times) {
        forwards.push_back(motion.at(time));
    }
    QVERIFY(!areSameMotion(*forwards.front(), *forwards.back()));
    for (std::size_t i = times.size(); i-- > 0;) {
        SceneMotion alone(scene);
        QVERIFY2(areSameMotion(*motion.at(times[i]), *forwards[i]), qPrintable(QString::number(i)));
        QVERIFY2(areSameMotion(*alone.at(times[i]), *forwards[i]), qPrintable(QString::number(i)));
    }
}

void TestSceneMotion::whatIsKeptIsNotSimulatedAgain()
{
    const model::Scene scene = strollScene();
    SceneMotion motion(scene);
    int steps = 0;
    const auto count = [&steps](double /*seconds*/) { ++steps; };
    (void)motion.at(2.0, nullptr, count);
    QCOMPARE(steps, 60);
    for (const double time : {0.5, 1.99, 0.0, 2.0}) {
        QVERIFY(motion.at(time, nullptr, count) != nullptr);
    }
    QCOMPARE(steps, 60);
    (void)motion.at(2.5, nullptr, count);
    QCOMPARE(steps, 75);
}

void TestSceneMotion::theLastStepIsKeptOnce()
{
    const model::Scene scene = strollScene();
    const auto cache = std::make_shared<MotionCache>();
    RecordedSession run(std::make_unique<Session>(scene), cache);
    run.take();
    QCOMPARE(cache->extent().steps, std::size_t{0});
    run.advance();
    QCOMPARE(cache->extent().steps, std::size_t{1});
    QCOMPARE(run.wholeMotion()->extent().steps, std::size_t{2});
    QCOMPARE(run.wholeMotion()->extent().steps, std::size_t{2});
    run.advance();
    QCOMPARE(cache->extent().steps, std::size_t{2});
    run.step();
    run.take(); // and nobody keeps the one before
    run.advance();
    QCOMPARE(cache->extent().steps, std::size_t{4});
    QCOMPARE(run.wholeMotion()->extent().last, 4.0 / 30.0);
    QCOMPARE(run.before()->seconds, 3.0 / 30.0);
}

/// What is told at a step is seen at it, and is what is kept of it.
void TestSceneMotion::anEditChangesTheLastStep()
{
    model::Scene scene = strollScene();
    RecordedSession run(std::make_unique<Session>(scene), std::make_shared<MotionCache>());
    run.take();
    run.advance();
    const model::IndividualId first = scene.population.ids()[0];
    scene.population.setValues<glm::vec3>(motionKeys::position, {{first}}, {{{7.0F, 0.0F, -3.0F}}});
    run.session().adopt(scene);
    QCOMPARE(run.take()->x[0], 7.0F);
    QVERIFY(run.before() != nullptr && run.before()->seconds == 0.0);
    run.advance();
    const auto kept = behavior::MotionReader(run.motion()).around(1.5 / 30.0).first;
    QVERIFY(kept != nullptr);
    QCOMPARE(kept->x[0], 7.0F);
}

void TestSceneMotion::nothingIsKeptWithoutACache()
{
    const model::Scene scene = strollScene();
    RecordedSession run(std::make_unique<Session>(scene), nullptr);
    run.take();
    for (int i = 0; i < 3; ++i) {
        run.advance();
    }
    QVERIFY(run.motion() == nullptr && run.wholeMotion() == nullptr);
    QVERIFY(run.around(2.5 / 30.0).first != nullptr);
    QVERIFY(run.around(0.5 / 30.0).first == nullptr);
}

CROWD_TEST(TestSceneMotion)
#include "tst_SceneMotion.moc"
