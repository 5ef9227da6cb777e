// SPDX-License-Identifier: MIT
#include "model/brush/BrushSettings.h"

#include <cmath>

#include <QtTest/QTest>

#include "tests/model/BrushScene.h"
#include "tests/program/Test.h"

using namespace crowd::test;

class tst_BrushSettings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void mainNumbersStayInTheirLimits();
    void mainNumberIsOneThatTheStrokeUses_data();
    void mainNumberIsOneThatTheStrokeUses();
};

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
