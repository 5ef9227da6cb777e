// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include <glm/gtc/constants.hpp>

#include "tests/program/Test.h"
#include "widgets/commands/CameraMoves.h"
#include "widgets/state/CameraMotion.h"

using namespace crowd::widgets;
using crowd::model::Bounds;
using crowd::model::Camera;
using crowd::model::Projection;
using crowd::model::View;

namespace {

constexpr glm::vec2 kSize(800.0F, 600.0F);

Camera theatreCamera()
{
    return Camera::lookingAt({9.0F, 6.0F, 14.0F}, {0.0F, 1.0F, 0.0F});
}

glm::vec2 pixelOf(const Camera& camera, const glm::vec3& point)
{
    return glm::vec2(View(camera, kSize).project(point).value_or(glm::vec3(-1e6F)));
}

bool isNear(const glm::vec3& a, const glm::vec3& b, float tolerance = 1e-3F)
{
    return glm::length(a - b) <= tolerance;
}

/// A camera that shows nothing has no number in it that is not one.
bool isSane(const Camera& camera)
{
    const float sum = glm::dot(camera.position, camera.position) + camera.pivotDistance +
                      camera.orthographicHeight + camera.fovYRadians;
    return std::isfinite(sum) && std::abs(glm::length(camera.orientation) - 1.0F) < 1e-3F;
}

} // namespace

class TestViewportCamera : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void orbitKeepsThePointAtItsPixel();
    void orbitNeverTipsOver();
    void orbitKeepsTheHorizonLevel();
    void panFollowsThePointer_data();
    void panFollowsThePointer();
    void dollyKeepsThePointAtItsPixel_data();
    void dollyKeepsThePointAtItsPixel();
    void dollyStopsShortOfThePoint();
    void framedShowsEveryCorner_data();
    void framedShowsEveryCorner();
    void framedFillsThePicture();
    void frontLooksIntoTheirFaces();
    void projectionKeepsThePivotsSize();
    void wildMovesStaySane();
    void motionEndsExactlyAtItsTarget();
    void flyingGoesWhereTheCameraLooks();
};

void TestViewportCamera::orbitKeepsThePointAtItsPixel()
{
    const Camera camera = theatreCamera();
    const glm::vec3 pivot = camera.pivot();
    const Camera turned = orbited(camera, pivot, 0.7F, -0.2F);
    QVERIFY(glm::length(pixelOf(turned, pivot) - kSize * 0.5F) < 0.05F);
    QVERIFY(std::abs(glm::length(turned.position - pivot) - glm::length(camera.position - pivot)) <
            1e-3F);
    // Around a point beside the axis, its distance stays.
    const glm::vec3 beside(3.0F, 0.5F, 2.0F);
    const Camera about = orbited(camera, beside, 1.1F, 0.1F);
    QVERIFY(std::abs(glm::length(about.position - beside) - glm::length(camera.position - beside)) <
            1e-3F);
}

void TestViewportCamera::orbitNeverTipsOver()
{
    Camera camera = theatreCamera();
    for (int i = 0; i < 100; ++i) {
        camera = orbited(camera, glm::vec3(0.0F), 0.3F, 0.4F);
        QVERIFY(camera.up().y > 0.0F);
    }
    for (int i = 0; i < 100; ++i) {
        camera = orbited(camera, glm::vec3(0.0F), 0.3F, -0.4F);
        QVERIFY(camera.up().y > 0.0F);
    }
    // From straight above there is a way back.
    const Camera top = lookingFrom(camera, ViewDirection::Top);
    QVERIFY(orbited(top, top.pivot(), 0.0F, 0.5F).forward().y > -0.9F);
}

void TestViewportCamera::orbitKeepsTheHorizonLevel()
{
    Camera camera = theatreCamera();
    for (int i = 0; i < 500; ++i) {
        camera = orbited(camera, glm::vec3(1.0F, 0.0F, 2.0F), 0.013F,
                         static_cast<float>(i % 3 - 1) * 0.02F);
    }
    QVERIFY(std::abs(camera.right().y) < 1e-3F);
}

void TestViewportCamera::panFollowsThePointer_data()
{
    QTest::addColumn<int>("projection");
    QTest::newRow("in perspective") << static_cast<int>(Projection::Perspective);
    QTest::newRow("in orthographic projection") << static_cast<int>(Projection::Orthographic);
}

void TestViewportCamera::panFollowsThePointer()
{
    QFETCH(int, projection);
    Camera camera = theatreCamera();
    camera.projection = static_cast<Projection>(projection);
    const glm::vec3 point(2.0F, 0.0F, 3.0F);
    const Camera moved = panned(camera, kSize, {40.0F, -25.0F}, depthOf(camera, point));
    const glm::vec2 way = pixelOf(moved, point) - pixelOf(camera, point);
    QVERIFY(glm::length(way - glm::vec2(40.0F, -25.0F)) < 0.05F);
}

void TestViewportCamera::dollyKeepsThePointAtItsPixel_data()
{
    QTest::addColumn<int>("projection");
    QTest::addColumn<float>("factor");
    QTest::newRow("in, perspective") << static_cast<int>(Projection::Perspective) << 0.5F;
    QTest::newRow("out, perspective") << static_cast<int>(Projection::Perspective) << 2.0F;
    QTest::newRow("in, orthographic") << static_cast<int>(Projection::Orthographic) << 0.5F;
    QTest::newRow("out, orthographic") << static_cast<int>(Projection::Orthographic) << 2.0F;
}

void TestViewportCamera::dollyKeepsThePointAtItsPixel()
{
    QFETCH(int, projection);
    QFETCH(float, factor);
    Camera camera = theatreCamera();
    camera.projection = static_cast<Projection>(projection);
    const glm::vec3 point(-4.0F, 1.0F, 2.0F);
    const Camera moved = dollied(camera, point, factor);
    QVERIFY(glm::length(pixelOf(moved, point) - pixelOf(camera, point)) < 0.05F);
    const auto metre = [&](const Camera& c) {
        return View(c, kSize).pixelsPerMetre(depthOf(c, point));
    };
    QVERIFY(std::abs(metre(moved) / metre(camera) * factor - 1.0F) < 0.01F);
}

void TestViewportCamera::dollyStopsShortOfThePoint()
{
    Camera camera = theatreCamera();
    const glm::vec3 point(0.0F, 1.0F, 0.0F);
    for (int i = 0; i < 200; ++i) {
        camera = dollied(camera, point, 0.7F);
    }
    QVERIFY(glm::dot(point - camera.position, camera.forward()) > 0.05F);
    for (int i = 0; i < 200; ++i) {
        camera = dollied(camera, point, 1.5F);
    }
    QVERIFY(glm::length(camera.position) < 10000.0F);
    QVERIFY(isSane(camera));
}

void TestViewportCamera::framedShowsEveryCorner_data()
{
    QTest::addColumn<int>("projection");
    QTest::addColumn<float>("width");
    QTest::addColumn<float>("height");
    QTest::addColumn<float>("depth");
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        const char* name = projection == Projection::Perspective ? "perspective" : "orthographic";
        const int value = static_cast<int>(projection);
        QTest::addRow("a person, %s", name) << value << 0.6F << 1.8F << 0.4F;
        QTest::addRow("a wide theatre, %s", name) << value << 60.0F << 12.0F << 30.0F;
        QTest::addRow("a deep street, %s", name) << value << 6.0F << 5.0F << 200.0F;
        QTest::addRow("a flat square, %s", name) << value << 20.0F << 0.0F << 20.0F;
    }
}

void TestViewportCamera::framedShowsEveryCorner()
{
    QFETCH(int, projection);
    QFETCH(float, width);
    QFETCH(float, height);
    QFETCH(float, depth);
    Camera camera = theatreCamera();
    camera.projection = static_cast<Projection>(projection);
    const Bounds box{glm::vec3(5.0F, 0.0F, 5.0F), glm::vec3(5.0F + width, height, 5.0F + depth)};
    const Camera moved = framed(camera, kSize, box);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 point((corner & 1) != 0 ? box.high.x : box.low.x,
                              (corner & 2) != 0 ? box.high.y : box.low.y,
                              (corner & 4) != 0 ? box.high.z : box.low.z);
        const auto pixel = View(moved, kSize).project(point);
        QVERIFY(pixel.has_value());
        QVERIFY(pixel->x >= 0.0F && pixel->x <= kSize.x && pixel->y >= 0.0F && pixel->y <= kSize.y);
    }
    QVERIFY(isNear(moved.forward(), camera.forward()));
}

void TestViewportCamera::framedFillsThePicture()
{
    const Bounds box{glm::vec3(-10.0F, 0.0F, -0.1F), glm::vec3(10.0F, 10.0F, 0.1F)};
    const Camera moved = framed(lookingFrom(theatreCamera(), ViewDirection::Front), kSize, box);
    const float width =
        pixelOf(moved, {10.0F, 0.0F, 0.0F}).x - pixelOf(moved, {-10.0F, 0.0F, 0.0F}).x;
    QVERIFY(width > 0.85F * kSize.x);
}

void TestViewportCamera::frontLooksIntoTheirFaces()
{
    const Camera camera = theatreCamera();
    QVERIFY(isNear(lookingFrom(camera, ViewDirection::Front).forward(), {0.0F, 0.0F, -1.0F}));
    QVERIFY(isNear(lookingFrom(camera, ViewDirection::Side).forward(), {-1.0F, 0.0F, 0.0F}));
    const Camera top = lookingFrom(camera, ViewDirection::Top);
    QVERIFY(isNear(top.forward(), {0.0F, -1.0F, 0.0F}));
    QVERIFY(isNear(top.up(), {0.0F, 0.0F, -1.0F}));
    QVERIFY(isNear(top.pivot(), camera.pivot()));
}

void TestViewportCamera::projectionKeepsThePivotsSize()
{
    const Camera camera = theatreCamera();
    const Camera other = withOtherProjection(camera);
    QCOMPARE(other.projection, Projection::Orthographic);
    const float before = View(camera, kSize).pixelsPerMetre(camera.pivotDistance);
    const float after = View(other, kSize).pixelsPerMetre(1.0F);
    QVERIFY(std::abs(before / after - 1.0F) < 1e-3F);
    const Camera back = withOtherProjection(other);
    QCOMPARE(back.projection, Projection::Perspective);
    QVERIFY(isNear(back.position, camera.position, 0.01F));
}

void TestViewportCamera::wildMovesStaySane()
{
    Camera camera = theatreCamera();
    for (int i = 0; i < 2000; ++i) {
        const float wild = static_cast<float>((i * 7919) % 401 - 200);
        camera = orbited(camera, {wild, 0.0F, -wild}, wild, -wild * 0.3F);
        camera = panned(camera, kSize, {wild * 9.0F, wild * 5.0F}, camera.pivotDistance);
        camera = dollied(camera, {wild, 1.0F, 0.0F}, i % 2 == 0 ? 0.01F : 90.0F);
        camera = flown(camera, glm::vec3(wild));
        if (i % 50 == 0) {
            camera = withOtherProjection(camera);
        }
        QVERIFY(isSane(camera));
    }
}

void TestViewportCamera::motionEndsExactlyAtItsTarget()
{
    const Camera from = theatreCamera();
    const Camera to = lookingFrom(from, ViewDirection::Top);
    CameraMotion motion;
    motion.start(from, to);
    const Camera half = motion.advance(CameraMotion::kSeconds * 0.5);
    QVERIFY(motion.isMoving());
    QVERIFY(half != from && half != to);
    // The pivot is common to both, so it stays in the middle all the way.
    QVERIFY(isNear(half.pivot(), from.pivot(), 0.01F));
    QVERIFY(motion.advance(CameraMotion::kSeconds) == to);
    QVERIFY(!motion.isMoving());
}

void TestViewportCamera::flyingGoesWhereTheCameraLooks()
{
    const Camera camera = theatreCamera();
    const Camera moved = flown(camera, {0.0F, 0.0F, 3.0F});
    QVERIFY(isNear(moved.position, camera.position + camera.forward() * 3.0F));
    QVERIFY(isNear(turned(camera, 0.4F, 0.1F).position, camera.position));
}

CROWD_TEST(TestViewportCamera)
#include "tst_ViewportCamera.moc"
