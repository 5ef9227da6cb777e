// SPDX-License-Identifier: MIT
#include "model/brush/BrushSettings.h"

#include <cmath>

#include <QtTest/QTest>
#include <nlohmann/json.hpp>

#include "model/brush/BrushJson.h"
#include "tests/model/BrushScene.h"
#include "tests/program/Test.h"

using namespace crowd::test;

class tst_BrushSettings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyBrushIsTheSameAfterItsJson();
    void wrongPresetsAreRefusedByName_data();
    void wrongPresetsAreRefusedByName();
    void mainNumbersStayInTheirLimits();
    void mainNumberIsOneThatTheStrokeUses_data();
    void mainNumberIsOneThatTheStrokeUses();
};

void tst_BrushSettings::everyBrushIsTheSameAfterItsJson()
{
    for (const BrushType& type : brushTypes()) {
        const auto kind = static_cast<BrushKind>(&type - brushTypes().data());
        BrushSettings set = initialBrush(kind).withMainNumber(1.5);
        set.selection = BrushSelection::AllInCircle;
        set.radiusPixels = 77.0F;
        const auto read = brushFromJson(brushJson(set));
        QVERIFY2(read, read ? "" : read.error().message.c_str());
        QVERIFY2(brushJson(read.value()) == brushJson(set), type.info.id);
        QVERIFY(withRemembered(initialBrush(kind), brushJson(set)).radiusPixels == 77.0F);
    }
}

void tst_BrushSettings::wrongPresetsAreRefusedByName_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("named");
    QTest::newRow("no object") << QStringLiteral("[1]") << QStringLiteral("must be an object");
    QTest::newRow("no brush") << QStringLiteral("{}") << QStringLiteral("brush.brush is missing");
    QTest::newRow("a brush that there is none of")
        << QStringLiteral("{\"brush\":\"broom\"}") << QStringLiteral("must be one of: create");
    QTest::newRow("a number that is too large")
        << QStringLiteral("{\"brush\":\"colour\",\"radius\":1e9}")
        << QStringLiteral("brush.radius");
    QTest::newRow("a tag that is too large")
        << QStringLiteral("{\"brush\":\"colour\",\"mask\":{\"tags\":[3,64]}}")
        << QStringLiteral("brush.mask.tags must lie between 0 and 63");
    QTest::newRow("a template below all")
        << QStringLiteral("{\"brush\":\"template\",\"settings\":{\"templates\":[-1]}}")
        << QStringLiteral("brush.settings.templates must lie between");
    QTest::newRow("a setting of another brush")
        << QStringLiteral("{\"brush\":\"colour\",\"settings\":{\"speed\":1}}")
        << QStringLiteral("brush.settings has no \"speed\"");
    QTest::newRow("a member that nobody knows")
        << QStringLiteral("{\"brush\":\"colour\",\"sparkle\":1}")
        << QStringLiteral("no \"sparkle\"");
}

void tst_BrushSettings::wrongPresetsAreRefusedByName()
{
    QFETCH(QString, text);
    QFETCH(QString, named);
    const auto read = brushFromJson(nlohmann::json::parse(text.toStdString()));
    QVERIFY(!read);
    const QString said = QString::fromStdString(read.error().message);
    QVERIFY2(said.contains(named), qPrintable(said));
}

void tst_BrushSettings::mainNumbersStayInTheirLimits()
{
    for (int kind = 0; kind < static_cast<int>(kBrushCount); ++kind) {
        const BrushSettings settings = brush(static_cast<BrushKind>(kind), BrushSelection::Point);
        const MainNumber number = settings.mainNumber();
        const BrushSettings changed = settings.withMainNumber(number.value - number.step);
        const double wanted = number.isCyclic ? number.value - number.step
                                              : std::max(number.low, number.value - number.step);
        QVERIFY(std::abs(changed.mainNumber().value - wanted) < 1.0e-4);
        const double most = settings.withMainNumber(1.0e9).mainNumber().value;
        QVERIFY(most <= number.high + 1.0e-4);
    }
    BrushSettings settings;
    QCOMPARE(settings.resized(5.0F).radiusPixels, settings.radiusPixels + 5.0F);
    QCOMPARE(settings.resized(-1.0e6F).radiusPixels, kMinRadiusPixels);
}

void tst_BrushSettings::mainNumberIsOneThatTheStrokeUses_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("selection");
    QTest::addColumn<bool>("seats");
    QTest::addColumn<QString>("label");
    const auto row = [](const char* name, BrushKind kind, BrushSelection selection, bool seats,
                        const char* label) {
        QTest::newRow(name) << static_cast<int>(kind) << static_cast<int>(selection) << seats
                            << QString::fromUtf8(label);
    };
    using enum BrushSelection;
    row("spraying people", BrushKind::Create, Spray, true, "Rate, a second");
    row("filling seats", BrushKind::Create, Rectangle, true, "Seats filled, %");
    row("dots along seats", BrushKind::Create, Point, true, "Seats filled, %");
    row("filling the ground", BrushKind::Create, AllInCircle, false, "Characters per m²");
    row("dots on the ground", BrushKind::Create, Point, false, "Distance, m");
    row("spraying them away", BrushKind::Delete, Spray, true, "Rate, a second");
    row("deleting an area", BrushKind::Delete, AllInCircle, true, "Of them, %");
    row("turning along the stroke", BrushKind::Orientation, Spray, true, "Turned by, °");
}

void tst_BrushSettings::mainNumberIsOneThatTheStrokeUses()
{
    QFETCH(int, kind);
    QFETCH(int, selection);
    QFETCH(bool, seats);
    QFETCH(QString, label);
    BrushSettings settings =
        brush(static_cast<BrushKind>(kind), static_cast<BrushSelection>(selection));
    if (auto* create = settings.find<CreateSettings>()) {
        create->seats.isOn = seats;
    }
    QCOMPARE(QString::fromUtf8(settings.mainNumber().label), label);
}

CROWD_TEST(tst_BrushSettings)
#include "tst_BrushSettings.moc"
