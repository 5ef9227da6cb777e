// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include <QtTest/QTest>

#include "tests/model/BrushScene.h"
#include "tests/program/Test.h"

using namespace crowd::test;

namespace {

float headingOf(const BrushScene& scene, IndividualId id)
{
    return scene.people().column(columns::heading)[scene.people().rowOf(id)];
}

} // namespace

class tst_BrushOrientation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void turnsAlongTheStroke();
    void turnsAsTheModeSays();
    void gradientTurnsAllAlongTheLine();
    void turnsAwayFromAPoint();
};

void tst_BrushOrientation::turnsAlongTheStroke()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{-2, 0, 0}, {2, 0, 0}});
    BrushSettings settings = brush(BrushKind::Orientation, BrushSelection::AllInCircle);
    settings.as<OrientationSettings>().heading.mode = HeadingMode::AlongStroke;
    const View view = fromAbove();
    const auto outcome =
        scene.paint(view, settings, {pixelOf(view, {-2, 0, 0}), pixelOf(view, {2, 0, 0})});
    QCOMPARE(outcome.affected, 2);
    // To the right on screen is +X, a quarter turn from +Z.
    const float quarter = std::numbers::pi_v<float> / 2.0F;
    QVERIFY(std::abs(headingOf(scene, ids[0]) - quarter) < 1.0e-4F);
    QVERIFY(std::abs(headingOf(scene, ids[1]) - quarter) < 1.0e-4F);
}

void tst_BrushOrientation::turnsAsTheModeSays()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{-2, 0, 0}, {2, 0, 1}});
    BrushSettings settings = brush(BrushKind::Orientation, BrushSelection::Rectangle);
    HeadingSettings& heading = settings.as<OrientationSettings>().heading;
    const std::vector<glm::dvec2> all{{1.0, 1.0}, {1279.0, 767.0}};
    heading.mode = HeadingMode::Direction;
    heading.headingRadians = 1.0F;
    QCOMPARE(scene.paint(fromAbove(), settings, all).affected, 2);
    QCOMPARE(headingOf(scene, ids[0]), 1.0F);
    heading.mode = HeadingMode::TowardsPoint;
    heading.towardsPoint = {2.0F, 0.0F, 4.0F};
    QCOMPARE(scene.paint(fromAbove(), settings, all).affected, 2);
    QVERIFY(std::abs(headingOf(scene, ids[0]) - std::atan2(4.0F, 4.0F)) < 1.0e-5F);
    QVERIFY(std::abs(headingOf(scene, ids[1])) < 1.0e-5F);
    heading.mode = HeadingMode::Random;
    heading.spreadRadians = 0.2F;
    QCOMPARE(scene.paint(fromAbove(), settings, all).affected, 2);
    QVERIFY(std::abs(headingOf(scene, ids[0]) - 1.0F) <= 0.2F);
    QVERIFY(headingOf(scene, ids[0]) != headingOf(scene, ids[1]));
}

void tst_BrushOrientation::gradientTurnsAllAlongTheLine()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    BrushSettings settings = brush(BrushKind::Orientation, BrushSelection::Rectangle);
    settings.op = BrushOperator::Gradient;
    const View view = fromAbove();
    scene.paint(view, settings, {pixelOf(view, {-5, 0, -4}), pixelOf(view, {5, 0, 4})});
    for (const IndividualId id : ids) {
        QVERIFY(std::abs(headingOf(scene, id) - std::atan2(10.0F, 8.0F)) < 1.0e-3F);
    }
}

void tst_BrushOrientation::turnsAwayFromAPoint()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 0}});
    BrushSettings settings = brush(BrushKind::Orientation, BrushSelection::AllInCircle);
    settings.as<OrientationSettings>().heading.mode = HeadingMode::TowardsPoint;
    settings.as<OrientationSettings>().heading.towardsPoint = {5, 0, 0};
    constexpr float kQuarter = std::numbers::pi_v<float> / 2.0F;
    (void)scene.paint(fromAbove(), settings, {{640, 384}});
    QVERIFY(std::abs(headingOf(scene, ids[0]) - kQuarter) < 1.0e-5F);
    settings = settings.withMainNumber(180.0);
    (void)scene.paint(fromAbove(), settings, {{640, 384}});
    QVERIFY(std::abs(headingOf(scene, ids[0]) + kQuarter) < 1.0e-5F);
}

CROWD_TEST(tst_BrushOrientation)
#include "tst_BrushOrientation.moc"
