// SPDX-License-Identifier: MIT
#include <cmath>

#include <QtTest/QTest>

#include "tests/program/Test.h"
#include "widgets/viewport/PictureScale.h"

using crowd::widgets::PictureScale;

namespace {

/// A machine that takes so long for a whole picture: some of it whatever its size, the rest by its
/// pixels.
struct Machine
{
    double fixedMs;
    double pixelsMs;

    void draw(PictureScale& scale, int pictures) const
    {
        for (int i = 0; i < pictures; ++i) {
            scale.note(fixedMs + pixelsMs * scale.share() * scale.share());
        }
    }
    [[nodiscard]] double at(double share) const { return fixedMs + pixelsMs * share * share; }
};

} // namespace

/// Pictures are drawn as large as a machine keeps up with.
class TestPictureScale : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aQuickMachineDrawsAll();
    void aSlowOneDrawsLess();
    void itSettles();
    void itGrowsAgain();
    void oneHitchIsNothing();
};

void TestPictureScale::aQuickMachineDrawsAll()
{
    PictureScale scale;
    Machine{4.0, 20.0}.draw(scale, 100);
    QCOMPARE(scale.share(), 1.0);
}

void TestPictureScale::aSlowOneDrawsLess()
{
    PictureScale scale;
    const Machine slow{10.0, 50.0};
    slow.draw(scale, 30);
    QVERIFY(scale.share() < 0.75 && scale.share() > 0.5);
    QVERIFY(slow.at(scale.share()) <= 33.0);
    // One that never keeps up: it is not made smaller for ever.
    Machine{100.0, 200.0}.draw(scale, 100);
    QCOMPARE(scale.share(), 0.5);
}

void TestPictureScale::itSettles()
{
    for (double pixels = 5.0; pixels < 200.0; pixels *= 1.07) {
        PictureScale scale;
        const Machine machine{6.0, pixels};
        machine.draw(scale, 60);
        const double settled = scale.share();
        for (int i = 0; i < 60; ++i) {
            machine.draw(scale, 1);
            QCOMPARE(scale.share(), settled);
        }
    }
}

void TestPictureScale::itGrowsAgain()
{
    PictureScale scale;
    Machine{20.0, 100.0}.draw(scale, 60);
    QVERIFY(scale.share() < 0.6);
    Machine{5.0, 15.0}.draw(scale, 60);
    QCOMPARE(scale.share(), 1.0);
    Machine{100.0, 200.0}.draw(scale, 60);
    scale.forget();
    QCOMPARE(scale.share(), 1.0);
}

void TestPictureScale::oneHitchIsNothing()
{
    PictureScale scale;
    const Machine machine{4.0, 20.0};
    for (int i = 0; i < 20; ++i) {
        machine.draw(scale, 5);
        scale.note(400.0);
    }
    QCOMPARE(scale.share(), 1.0);
}

CROWD_TEST(TestPictureScale)
#include "tst_PictureScale.moc"
