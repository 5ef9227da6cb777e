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
    for (int kind = 0; kind < 5; ++kind) {
        const BrushSettings settings = brush(static_cast<BrushKind>(kind), BrushSelection::Point);
        const MainNumber number = settings.mainNumber();
        const BrushSettings changed = settings.withMainNumber(number.value - number.step);
        QVERIFY(std::abs(changed.mainNumber().value - (number.value - number.step)) < 1.0e-4);
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
    QTest::addColumn<int>("quantity");
    const auto row = [](const char* name, BrushKind kind, BrushSelection selection, bool seats,
                        MainQuantity quantity) {
        QTest::newRow(name) << static_cast<int>(kind) << static_cast<int>(selection) << seats
                            << static_cast<int>(quantity);
    };
    using enum BrushSelection;
    row("spraying people", BrushKind::Create, Spray, true, MainQuantity::Rate);
    row("filling seats", BrushKind::Create, Rectangle, true, MainQuantity::SeatPercent);
    row("dots along seats", BrushKind::Create, Point, true, MainQuantity::SeatPercent);
    row("filling the ground", BrushKind::Create, AllInCircle, false, MainQuantity::Density);
    row("dots on the ground", BrushKind::Create, Point, false, MainQuantity::Distance);
    row("spraying them away", BrushKind::Delete, Spray, true, MainQuantity::Rate);
    row("deleting an area", BrushKind::Delete, AllInCircle, true, MainQuantity::DeletePercent);
    row("turning along the stroke", BrushKind::Orientation, Spray, true, MainQuantity::Turn);
}

void tst_BrushSettings::mainNumberIsOneThatTheStrokeUses()
{
    QFETCH(int, kind);
    QFETCH(int, selection);
    QFETCH(bool, seats);
    QFETCH(int, quantity);
    BrushSettings settings =
        brush(static_cast<BrushKind>(kind), static_cast<BrushSelection>(selection));
    settings.create.seats.isOn = seats;
    QCOMPARE(static_cast<int>(settings.mainNumber().quantity), quantity);
}

CROWD_TEST(tst_BrushSettings)
#include "tst_BrushSettings.moc"
