// SPDX-License-Identifier: MIT
#include "model/scene/LightCue.h"

#include <cmath>

#include <QtTest/QTest>

#include "tests/program/Test.h"

using namespace crowd::model;

/// What lights were told, at moments of a run.
class TestLightCues : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatWasToldNothingIsAsTheSceneHasIt();
    void fadesBeginWhereItIs();
    void flashesFadeAway();
    void sweepsEndWhereTheyBegan();
    void toldAgainChangesNothing();
    void atOnce();
};

namespace {

Light lightWith(LightId id, bool isOn = true)
{
    Light light;
    light.id = id;
    light.isOn = isOn;
    return light;
}

float shareOf(const Light& light, const LightCues& cues, double now)
{
    return lightNow(light, &cues, now).share;
}

} // namespace

void TestLightCues::whatWasToldNothingIsAsTheSceneHasIt()
{
    LightCues cues;
    tellLight(cues, lightWith(1), LightDeed::Off, 0.0F, 1.0);
    QCOMPARE(lightNow(lightWith(2), &cues, 3.0).share, 1.0F);
    QCOMPARE(lightNow(lightWith(2, false), &cues, 3.0).share, 0.0F);
    QCOMPARE(lightNow(lightWith(2), nullptr, 3.0).share, 1.0F);
}

void TestLightCues::fadesBeginWhereItIs()
{
    const Light light = lightWith(1, false);
    LightCues cues;
    tellLight(cues, light, LightDeed::On, 2.0F, 10.0);
    QCOMPARE(shareOf(light, cues, 9.0), 0.0F);
    QCOMPARE(shareOf(light, cues, 10.5), 0.25F);
    tellLight(cues, light, LightDeed::Off, 1.0F, 11.0); // half way
    QCOMPARE(shareOf(light, cues, 11.0), 0.5F);
    QCOMPARE(shareOf(light, cues, 11.5), 0.25F);
    QCOMPARE(shareOf(light, cues, 99.0), 0.0F);
}

void TestLightCues::flashesFadeAway()
{
    for (const bool isOn : {true, false}) {
        const Light light = lightWith(1, isOn);
        const float before = isOn ? 1.0F : 0.0F;
        LightCues cues;
        tellLight(cues, light, LightDeed::Flash, 0.5F, 2.0);
        QVERIFY(shareOf(light, cues, 2.0) > before + 2.0F);
        QVERIFY(shareOf(light, cues, 2.25) < shareOf(light, cues, 2.1));
        QCOMPARE(shareOf(light, cues, 2.5), before);
    }
}

void TestLightCues::sweepsEndWhereTheyBegan()
{
    Light light = lightWith(1);
    light.position = {0.0F, 8.0F, 0.0F};
    LightCues cues;
    tellLight(cues, light, LightDeed::Sweep, 4.0F, 0.0);
    const auto aim = [&](double now) {
        return turnedAim(light, {0.0F, 0.0F, 10.0F}, lightNow(light, &cues, now).turnRadians);
    };
    QVERIFY(aim(1.0).x > 4.0F);
    QVERIFY(std::abs(aim(2.0).x) < 0.01F);
    QVERIFY(aim(3.0).x < -4.0F);
    QCOMPARE(aim(5.0), glm::vec3(0.0F, 0.0F, 10.0F));
    QVERIFY(std::abs(std::hypot(aim(1.0).x, aim(1.0).z) - 10.0F) < 0.01F); // around the lamp
    QCOMPARE(aim(1.0).y, 0.0F);
}

void TestLightCues::toldAgainChangesNothing()
{
    const Light light = lightWith(1);
    for (const LightDeed deed :
         {LightDeed::On, LightDeed::Off, LightDeed::Flash, LightDeed::Sweep}) {
        LightCues cues;
        tellLight(cues, light, deed, 2.0F, 0.0);
        const LightCues first = cues;
        tellLight(cues, light, deed, 2.0F, 0.0);
        tellLight(cues, light, deed, 2.0F, 1.0);
        QCOMPARE(cues, first);
        tellLight(cues, light, deed, 2.0F, 2.5); // that is over: flashes and sweeps come again
        QCOMPARE(cues != first, deed == LightDeed::Flash || deed == LightDeed::Sweep);
    }
}

void TestLightCues::atOnce()
{
    const Light light = lightWith(1);
    LightCues cues;
    tellLight(cues, light, LightDeed::Off, 0.0F, 3.0);
    QCOMPARE(shareOf(light, cues, 3.0), 0.0F);
    tellLight(cues, light, LightDeed::Flash, 0.0F, 4.0); // would not be seen
    QVERIFY(shareOf(light, cues, 4.05) > 0.0F);
    QVERIFY(std::isfinite(shareOf(light, cues, 1e12)));
}

CROWD_TEST(TestLightCues)
#include "tst_LightCues.moc"
