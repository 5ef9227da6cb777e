// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <QtTest/QTest>
#include <glm/geometric.hpp>

#include "model/scene/PlaceShape.h"
#include "tests/program/Test.h"

using namespace crowd::model;

namespace {

Place shapeOver(PlaceShape shape, const std::vector<glm::vec3>& corners, float radius = 0.5F)
{
    Place place;
    place.id = 1;
    place.radius = radius;
    place.shape = shape;
    setCorners(place, corners);
    return place;
}

/// An L, the middle of whose bounds is not in it.
const std::vector<glm::vec3> kBend{{0, 0, 0}, {10, 0, 0}, {10, 0, 2},
                                   {2, 0, 2}, {2, 0, 10}, {0, 0, 10}};

} // namespace

/// What ground round places, lines and areas take up.
class TestPlaceShape : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void linesAreWithinTheirWidth();
    void areasAreWhatTheyEnclose();
    void positionsAreOnWhatIsThere();
    void takeUpSquareMetres();
    void areWholeWithCornersEnough();
};

void TestPlaceShape::linesAreWithinTheirWidth()
{
    const Place wall = shapeOver(PlaceShape::Line, {{-5, 0, 0}, {5, 2, 0}, {5, 2, 5}});
    QVERIFY(isWithin(wall, {0.0F, 1.0F, 0.4F}));
    QVERIFY(isWithin(wall, {5.3F, 0.0F, -0.3F}));
    QVERIFY(isWithin(wall, {4.6F, 0.0F, 4.0F}));
    QVERIFY(!isWithin(wall, {0.0F, 0.0F, 0.6F}));
    QVERIFY(!isWithin(wall, {0.0F, 0.0F, 2.5F})); // what it goes around is not it
    const glm::vec2 nearest = nearestOf(wall, {1.0F, -3.0F});
    QVERIFY(glm::distance(nearest, {1.0F, 0.0F}) < 1e-4F);
    QVERIFY(std::abs(reachOf(wall) - 0.5F - 7.5F) < 2.6F);
    for (const glm::vec3& corner : cornersOf(wall)) {
        QVERIFY(glm::distance(corner, wall.position) <= reachOf(wall) + 2.0F);
    }
}

void TestPlaceShape::areasAreWhatTheyEnclose()
{
    const Place bend = shapeOver(PlaceShape::Area, kBend, 0.05F);
    QVERIFY(isWithin(bend, {9.0F, 5.0F, 1.0F}));
    QVERIFY(isWithin(bend, {1.0F, -5.0F, 9.0F}));
    QVERIFY(!isWithin(bend, {5.0F, 0.0F, 5.0F}));
    QVERIFY(isWithin(bend, {10.04F, 0.0F, 1.0F}));
    QVERIFY(!isWithin(bend, {10.1F, 0.0F, 1.0F}));
    const glm::vec2 inside{1.5F, 1.5F};
    QVERIFY(nearestOf(bend, inside) == inside);
    QVERIFY(glm::distance(nearestOf(bend, {5.0F, 4.0F}), {5.0F, 2.0F}) < 1e-4F);
    // Moved, it takes its corners along.
    Place moved = bend;
    moved.position += glm::vec3(100.0F, 0.0F, 0.0F);
    QVERIFY(isWithin(moved, {109.0F, 0.0F, 1.0F}));
    QVERIFY(!isWithin(moved, {9.0F, 0.0F, 1.0F}));
}

void TestPlaceShape::positionsAreOnWhatIsThere()
{
    const Place bend = shapeOver(PlaceShape::Area, kBend);
    QVERIFY(isEnclosed(cornersOf(bend), {bend.position.x, bend.position.z}));
    const Place wall = shapeOver(PlaceShape::Line, {{0, 0, 0}, {8, 4, 0}, {8, 4, 2}});
    QVERIFY(glm::distance(wall.position, {5.0F, 2.5F, 0.0F}) < 1e-4F); // halfway along it
    const Place point = shapeOver(PlaceShape::Line, {{3, 0, 3}, {3, 0, 3}});
    QVERIFY(point.position == glm::vec3(3.0F, 0.0F, 3.0F));
    const Place flat = shapeOver(PlaceShape::Area, {{0, 0, 0}, {4, 0, 0}, {2, 0, 0}});
    QVERIFY(isWithin(flat, flat.position));
}

void TestPlaceShape::takeUpSquareMetres()
{
    QVERIFY(std::abs(areaOf(shapeOver(PlaceShape::Area, kBend, 0.001F)) - 36.0F) < 0.1F);
    QVERIFY(std::abs(areaOf(shapeOver(PlaceShape::Line, {{0, 0, 0}, {10, 0, 0}}, 1.0F)) - 23.14F) <
            0.01F);
    Place disc;
    disc.radius = 2.0F;
    QCOMPARE(roomOf(disc), 25U);
    QCOMPARE(roomOf(shapeOver(PlaceShape::Area, kBend, 0.001F)), 72U);
}

void TestPlaceShape::areWholeWithCornersEnough()
{
    QVERIFY(isWhole(Place()));
    Place place = shapeOver(PlaceShape::Line, {{0, 0, 0}, {1, 0, 0}});
    QVERIFY(isWhole(place));
    place.shape = PlaceShape::Area;
    QVERIFY(!isWhole(place));
    place.shape = PlaceShape::Round; // it may become a line again
    QVERIFY(isWhole(place));
    place = shapeOver(PlaceShape::Line, {{0, 0, 0}, {30'000, 0, 0}});
    QVERIFY(!isWhole(place));
    place.corners.assign(kMostCorners + 1, {});
    QVERIFY(!isWhole(place));
    place.corners = {{0, 0, 0}, {std::numeric_limits<float>::quiet_NaN(), 0, 0}};
    QVERIFY(!isWhole(place));
}

CROWD_TEST(TestPlaceShape)
#include "tst_PlaceShape.moc"
