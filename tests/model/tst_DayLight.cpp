// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <QtTest/QTest>

#include "model/describe/FieldChecks.h"
#include "model/scene/DayLight.h"
#include "model/scene/ReadyLight.h"
#include "tests/program/Test.h"

using namespace crowd::model;

namespace {

Lighting lightAt(float hours, float haze = 0.0F)
{
    Lighting light;
    light.haze = haze;
    setDayHours(light, hours);
    return light;
}

float brightestOf(const glm::vec3& color)
{
    return std::max({color.x, color.y, color.z});
}

} // namespace

/// Sun, moon and sky of an hour.
class TestDayLight : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theHourIsReadBack();
    void everyHourIsLegal();
    void aDayGoesItsWay();
    void hazeMakesItPale();
    void theSkyFollowsHaze();
    void theRestStays();
    void lampsGoOnAtDusk();
};

void TestDayLight::theHourIsReadBack()
{
    for (const float haze : {0.0F, 0.5F, 0.95F}) {
        for (float hours = 0.1F; hours < 23.95F; hours += 0.1F) {
            const float shown = dayHours(lightAt(hours, haze));
            QVERIFY2(
                std::abs(shown - hours) < 0.02F,
                qPrintable(QStringLiteral("%1 h, haze %2: %3").arg(hours).arg(haze).arg(shown)));
        }
    }
    QVERIFY(std::abs(dayHours(findReadyLight("dusk")->light) - 18.5F) < 0.3F);
    QVERIFY(std::abs(dayHours(findReadyLight("noon")->light) - 13.0F) < 0.5F);
    QVERIFY(dayHours(findReadyLight("night")->light) < 5.0F ||
            dayHours(findReadyLight("night")->light) > 20.0F);
    Lighting turned = lightAt(15.0F); // turned away, it is as late as before
    turned.sunAzimuthRadians += 0.4F;
    QVERIFY(std::abs(dayHours(turned) - 15.0F) < 0.02F);
    QVERIFY(std::abs(dayHours(lightAt(37.5F)) - 13.5F) < 0.02F); // round the clock
    QVERIFY(std::abs(dayHours(lightAt(-1.0F)) - 23.0F) < 0.02F);
}

void TestDayLight::everyHourIsLegal()
{
    for (float hours = 0.0F; hours < 24.0F; hours += 0.05F) {
        const Lighting light = lightAt(hours, 0.999F);
        for (const FieldInfo& field : fieldsOf<Lighting>()) {
            const auto checked = checkField(field, field.get(&light), field.meta.key);
            QVERIFY2(checked.isOk(), field.meta.key);
        }
        QVERIFY(light.sunElevationRadians > 0.0F);
    }
}

void TestDayLight::aDayGoesItsWay()
{
    const Lighting morning = lightAt(7.0F);
    const Lighting noon = lightAt(12.0F);
    const Lighting evening = lightAt(17.0F);
    const Lighting night = lightAt(0.5F);
    QVERIFY(morning.sunAzimuthRadians < -0.5F && evening.sunAzimuthRadians > 0.5F);
    QVERIFY(std::abs(noon.sunAzimuthRadians) < 0.01F);
    QVERIFY(noon.sunElevationRadians > evening.sunElevationRadians + 0.5F);
    QVERIFY(lightAt(18.8F).sunColor.z < noon.sunColor.z - 0.3F); // low, it is red
    QVERIFY(night.sunStrength < 0.3F * noon.sunStrength);
    QVERIFY(brightestOf(night.skyHorizon) < 0.3F && brightestOf(noon.skyHorizon) > 0.85F);
    // As the ready-made noon, which stands a little lower.
    const Lighting& ready = findReadyLight("noon")->light;
    QVERIFY(std::abs(noon.sunStrength - ready.sunStrength) < 0.05F);
    QVERIFY(std::abs(noon.ambientStrength - ready.ambientStrength) < 0.05F);
    // No jump from one quarter of an hour to the next, but for where sun and moon change places.
    for (float hours = 0.0F; hours < 24.0F; hours += 0.25F) {
        const glm::vec3 step = lightAt(hours).skyHorizon - lightAt(hours + 0.25F).skyHorizon;
        QVERIFY(std::max({std::abs(step.x), std::abs(step.y), std::abs(step.z)}) < 0.2F);
        QVERIFY(std::abs(lightAt(hours).sunStrength - lightAt(hours + 0.25F).sunStrength) < 0.45F);
    }
}

void TestDayLight::hazeMakesItPale()
{
    const Lighting clear = lightAt(15.0F);
    const Lighting hazy = lightAt(15.0F, 0.9F);
    const auto bright = [](const glm::vec3& c) {
        return brightestOf(c) - std::min({c.x, c.y, c.z});
    };
    QVERIFY(bright(hazy.skyZenith) < 0.6F * bright(clear.skyZenith));
    QVERIFY(hazy.sunStrength < 0.6F * clear.sunStrength);
    QVERIFY(hazy.shadowSoftnessRadians > 3.0F * clear.shadowSoftnessRadians);
    QVERIFY(hazy.ambientStrength > 1.3F * clear.ambientStrength);
}

void TestDayLight::theSkyFollowsHaze()
{
    for (const float hours : {8.0F, 15.0F, 18.5F, 23.0F}) {
        const Lighting clear = lightAt(hours);
        Lighting hazy = clear;
        hazy.haze = 0.8F;
        followHaze(hazy, clear);
        const Lighting wanted = lightAt(hours, 0.8F);
        QVERIFY(glm::length(hazy.skyHorizon - wanted.skyHorizon) < 0.03F);
        QVERIFY(std::abs(hazy.sunStrength - wanted.sunStrength) < 0.03F);
        Lighting again = hazy; // and back
        again.haze = 0.0F;
        followHaze(again, hazy);
        QVERIFY(glm::length(again.skyZenith - clear.skyZenith) < 0.05F);
    }
    // What somebody has chosen stays.
    Lighting own = lightAt(15.0F);
    own.skyZenith = {0.8F, 0.1F, 0.1F};
    Lighting hazy = own;
    hazy.haze = 0.8F;
    followHaze(hazy, own);
    QCOMPARE(hazy.skyZenith, own.skyZenith);
    QCOMPARE(hazy.sunStrength, own.sunStrength);
}

void TestDayLight::theRestStays()
{
    Lighting light = newLighting();
    light.ground = {0.1F, 0.2F, 0.3F};
    light.exposureStops = 1.5F;
    light.unknownMembers = "{\"x\":1}";
    const Lighting before = light;
    setDayHours(light, 20.0F);
    QCOMPARE(light.ground, before.ground);
    QCOMPARE(light.exposureStops, before.exposureStops);
    QCOMPARE(light.occlusion, before.occlusion);
    QCOMPARE(light.unknownMembers, before.unknownMembers);
}

void TestDayLight::lampsGoOnAtDusk()
{
    const auto isDarkIn = [](const char* key) { return isDark(findReadyLight(key)->light); };
    QVERIFY(isDarkIn("dusk") && isDarkIn("night"));
    QVERIFY(!isDarkIn("noon") && !isDarkIn("afternoon") && !isDarkIn("overcast"));
    QVERIFY(!isDarkIn("studio") && !isDark(newLighting()));
    int changes = 0;
    bool wasDark = true;
    for (float hours = 0.0F; hours < 24.0F; hours += 0.25F) {
        Lighting light;
        setDayHours(light, hours);
        changes += isDark(light) != wasDark ? 1 : 0;
        wasDark = isDark(light);
    }
    QCOMPARE(changes, 2); // off in the morning, on in the evening
    QVERIFY(wasDark);
}

CROWD_TEST(TestDayLight)
#include "tst_DayLight.moc"
