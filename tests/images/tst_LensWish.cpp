// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <QtTest/QTest>

#include "app/pictures/LensWish.h"
#include "tests/program/Test.h"

using namespace crowd;
using app::lensOf;
using app::LensWish;

/// Depth of field as it is asked for.
class TestLensWish : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void withoutAWishAllIsSharp();
    void theLensIsThatOfACamera();
    void eitherIsEnough();
    void whatCannotBeIsRefused();
};

void TestLensWish::withoutAWishAllIsSharp()
{
    const auto lens = lensOf({}, {});
    QVERIFY(lens.isOk() && !lens.value());
}

/// 50 mm, f/2: light comes through 25 mm.
void TestLensWish::theLensIsThatOfACamera()
{
    model::Camera camera;
    camera.fovYRadians = 2.0F * std::atan(0.24F);
    const auto lens = lensOf({7.0, 2.0}, camera);
    QVERIFY(lens.isOk() && lens.value());
    QCOMPARE(lens.value()->focusMetres, 7.0F);
    QVERIFY(std::abs(lens.value()->radiusMetres - 0.0125F) < 1e-6F);
}

void TestLensWish::eitherIsEnough()
{
    model::Camera camera;
    camera.pivotDistance = 9.0F;
    const auto turned = lensOf({std::nullopt, 1.0}, camera);
    QCOMPARE(turned.value()->focusMetres, 9.0F);
    const auto usual = lensOf({9.0, std::nullopt}, camera);
    QVERIFY(std::abs(usual.value()->radiusMetres -
                     turned.value()->radiusMetres / static_cast<float>(app::kUsualFStop)) < 1e-6F);
    camera.pivotDistance = 0.0F;
    QVERIFY(lensOf({std::nullopt, 1.0}, camera).isOk());
}

void TestLensWish::whatCannotBeIsRefused()
{
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    model::Camera camera;
    for (const double focus : {0.0, -1.0, 1e9, kNone}) {
        QVERIFY(!lensOf({focus, 1.0}, camera).isOk());
    }
    for (const double fStop : {0.0, -1.0, 1e9, kNone}) {
        QVERIFY(!lensOf({5.0, fStop}, camera).isOk());
    }
    camera.projection = model::Projection::Orthographic;
    const auto parallel = lensOf({5.0, 1.0}, camera);
    QVERIFY(!parallel.isOk());
    QVERIFY(parallel.error().message.find("orthographic") != std::string::npos);
    QVERIFY(lensOf({}, camera).isOk());
}

CROWD_TEST(TestLensWish)
#include "tst_LensWish.moc"
