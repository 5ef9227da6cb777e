// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "tests/behavior/StateScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

Scene sceneWithLight()
{
    Scene scene = rowOf(3);
    Light light;
    light.id = 4;
    light.isOn = false;
    scene.lights.push_back(light);
    return scene;
}

LightNow shown(const Session& session, const Light& light)
{
    const CrowdFramePtr frame = session.frame();
    return lightNow(light, frame->lightCues.get(), frame->seconds);
}

} // namespace

/// Rules that tell lights of the scene what to do.
class TestRuleLights : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneIsSwitchedOn();
    void eachOfACrowdMaySayIt();
    void editedLightsAreHeardOf();
    void lightsThatAreGoneAreSaid();
};

void TestRuleLights::oneIsSwitchedOn()
{
    Scene scene = sceneWithLight();
    scene.rules = {onEvent("up", {actions::TellLight{4, LightDeed::On, 2.0F}}),
                   onEvent("down", {actions::TellLight{4, LightDeed::Off, 0.0F}})};
    Session session(scene);
    QCOMPARE(shown(session, scene.lights[0]).share, 0.0F);
    session.send("up", 1.0F, {1});
    run(session, kStepsPerSecond);
    const float half = shown(session, scene.lights[0]).share;
    QVERIFY2(half > 0.3F && half < 0.6F, qPrintable(QString::number(half)));
    run(session, 2 * kStepsPerSecond);
    QCOMPARE(shown(session, scene.lights[0]).share, 1.0F);
    session.send("down", 1.0F, {2});
    run(session, 2);
    QCOMPARE(shown(session, scene.lights[0]).share, 0.0F);
}

/// At moments of their own: it goes on as the first has said.
void TestRuleLights::eachOfACrowdMaySayIt()
{
    Scene scene = sceneWithLight();
    scene.rules = {onEvent("up", {actions::TellLight{4, LightDeed::On, 1.0F}})};
    Session session(scene);
    for (const IndividualId id : scene.population.ids()) {
        session.send("up", 1.0F, {id});
        run(session, kStepsPerSecond / 3);
    }
    run(session, 3);
    QCOMPARE(shown(session, scene.lights[0]).share, 1.0F);
}

void TestRuleLights::editedLightsAreHeardOf()
{
    Scene scene = sceneWithLight();
    scene.rules = {onEvent("up", {actions::TellLight{7, LightDeed::On, 0.0F}})};
    Session session(scene);
    scene.lights[0].id = 7;
    session.adopt(scene);
    session.send("up", 1.0F, {1});
    run(session, 2);
    QCOMPARE(shown(session, scene.lights[0]).share, 1.0F);
    QVERIFY(session.problems().empty());
}

void TestRuleLights::lightsThatAreGoneAreSaid()
{
    Scene scene = sceneWithLight();
    scene.rules = {onEvent("up", {actions::TellLight{9}, tagWith(2)})};
    Session session(scene);
    session.send("up", 1.0F, {1});
    run(session, 3);
    QVERIFY(hasTag(session, 0, 2)); // the rest is done
    QVERIFY(std::ranges::any_of(session.problems(), [](const behavior::Problem& each) {
        return each.text.english().find("the light is not there") != std::string::npos;
    }));
}

CROWD_TEST(TestRuleLights)
#include "tst_RuleLights.moc"
