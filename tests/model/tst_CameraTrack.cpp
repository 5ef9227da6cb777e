// SPDX-License-Identifier: MIT
#include "model/view/CameraTrack.h"

#include <cmath>

#include <QtTest/QTest>

#include "model/project/ProjectReader.h"
#include "model/rules/MarkFlaws.h"
#include "tests/model/ProjectText.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using crowd::testing::projectText;

namespace {

constexpr float kPi = 3.14159265F;

Mark moveAt(double seconds, MarkId id, CameraMove move)
{
    Mark mark;
    mark.id = id;
    mark.seconds = seconds;
    mark.kind = MarkKind::Camera;
    mark.move = move;
    return mark;
}

Mark goTo(double seconds, MarkId id, const char* camera, float travel = 0.0F)
{
    Mark mark = moveAt(seconds, id, CameraMove::To);
    mark.camera = camera;
    mark.travel = travel;
    return mark;
}

/// Two cameras, and a way around a corner.
Scene stage()
{
    Scene scene;
    scene.cameras = {{"Stalls", Camera::lookingAt({0.0F, 2.0F, 20.0F}, {0.0F, 2.0F, 0.0F}), 3},
                     {"Gallery", Camera::lookingAt({20.0F, 12.0F, 0.0F}, {0.0F, 2.0F, 0.0F})}};
    scene.places = {{1, "a", {0.0F, 0.0F, 0.0F}},
                    {2, "b", {10.0F, 0.0F, 0.0F}},
                    {3, "c", {10.0F, 0.0F, 30.0F}}};
    scene.paths = {{1, "corner", PathKind::Simple, {1, 2, 3}},
                   {2, "round", PathKind::Cyclic, {1, 2, 3}},
                   {3, "spot", PathKind::Simple, {1}}};
    return scene;
}

bool isNear(const glm::vec3& a, const glm::vec3& b, float metres = 1e-3F)
{
    return glm::distance(a, b) <= metres;
}

} // namespace

class TestCameraTrack : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void beforeAllItIsTheFirstCamera();
    void cutsAndFliesToCameras();
    void aMoveGoesOnFromWhereTheLastOneIs();
    void turnsAroundWhatItLooksAt();
    void travelsAlongAPathAtAnEvenSpeed();
    void aClosedWayEndsWhereItBegan();
    void whatCannotBeIsSaidAndStays();
    void filesKeepIt();
};

void TestCameraTrack::beforeAllItIsTheFirstCamera()
{
    Scene scene = stage();
    QVERIFY(!CameraTrack(scene).hasMoves());
    scene.timeline = {goTo(5.0, 1, "Gallery")};
    const CameraTrack track(scene);
    QVERIFY(track.hasMoves());
    QCOMPARE(track.at(4.99), directed(scene.cameras[0]));
    QCOMPARE(track.at(4.99).look, LookId{3});
    QCOMPARE(track.at(5.0), directed(scene.cameras[1]));
    QCOMPARE(track.at(1e6), directed(scene.cameras[1]));
}

void TestCameraTrack::cutsAndFliesToCameras()
{
    Scene scene = stage();
    Mark flight = goTo(2.0, 1, "Gallery", 4.0F);
    flight.isGentle = false;
    scene.timeline = {flight};
    const CameraTrack even(scene);
    QVERIFY(isNear(even.at(2.0).camera.position, scene.cameras[0].camera.position));
    const DirectedCamera half = even.at(4.0);
    QVERIFY(half.name.empty());                               // nowhere that has a name
    QVERIFY(isNear(half.camera.pivot(), {0.0F, 2.0F, 0.0F})); // both look there, and so does it
    QCOMPARE(even.at(6.0), directed(scene.cameras[1]));
    scene.timeline[0].isGentle = true;
    const CameraTrack gentle(scene);
    const glm::vec3 from = scene.cameras[0].camera.position;
    QVERIFY(glm::distance(gentle.at(2.4).camera.position, from) <
            0.5F * glm::distance(even.at(2.4).camera.position, from));
    QVERIFY(isNear(gentle.at(4.0).camera.position, half.camera.position));
}

void TestCameraTrack::aMoveGoesOnFromWhereTheLastOneIs()
{
    Scene scene = stage();
    scene.timeline = {goTo(0.0, 1, "Gallery", 10.0F), goTo(5.0, 2, "Stalls", 10.0F)};
    const CameraTrack track(scene);
    QVERIFY(isNear(track.at(4.999).camera.position, track.at(5.001).camera.position, 0.02F));
    QCOMPARE(track.at(15.0), directed(scene.cameras[0]));
    const auto moves = track.moves();
    QVERIFY(moves.size() == 2 && std::abs(moves[0].end - 5.0) < 1e-5 && moves[1].end == 15.0);
    QVERIFY(isNear(track.at(moves[0].end).camera.position, track.at(5.0).camera.position));
    // The moment before one that is shown is not from before a cut.
    QVERIFY(track.before(4.0, 4.1) == track.at(4.0) && track.before(4.9, 5.1) == track.at(5.0));
    scene.timeline = {goTo(5.0, 1, "Stalls"), goTo(5.0, 2, "Gallery")}; // the later one wins
    QCOMPARE(CameraTrack(scene).at(5.0), directed(scene.cameras[1]));
}

void TestCameraTrack::turnsAroundWhatItLooksAt()
{
    Scene scene = stage();
    Mark around = moveAt(1.0, 1, CameraMove::Around);
    around.travel = 8.0F;
    around.isGentle = false;
    scene.timeline = {around};
    const CameraTrack track(scene);
    const Camera quarter = track.at(3.0).camera;
    QVERIFY(isNear(quarter.position, {20.0F, 2.0F, 0.0F})); // to the right
    QVERIFY(isNear(quarter.forward(), {-1.0F, 0.0F, 0.0F}));
    QVERIFY(isNear(track.at(9.0).camera.position, scene.cameras[0].camera.position));
    scene.timeline[0].turn = -kPi;
    scene.timeline[0].camera = "Gallery"; // begins there
    const Camera over = CameraTrack(scene).at(9.0).camera;
    QVERIFY(isNear(over.position, {-20.0F, 12.0F, 0.0F}, 2e-3F));
    const CameraTrack table = CameraTrack::turntable(directed(scene.cameras[0]), 2.0, 4.0);
    QVERIFY(isNear(table.at(4.0).camera.position, {0.0F, 2.0F, -20.0F}));
    QVERIFY(isNear(table.at(6.0).camera.position, {0.0F, 2.0F, 20.0F}));
}

void TestCameraTrack::travelsAlongAPathAtAnEvenSpeed()
{
    Scene scene = stage();
    Mark along = moveAt(0.0, 1, CameraMove::Along);
    along.path = 1;
    along.above = 3.0F;
    along.travel = 20.0F;
    along.isGentle = false;
    scene.timeline = {along};
    const CameraTrack track(scene);
    QVERIFY(isNear(track.at(0.0).camera.position, {0.0F, 3.0F, 0.0F}));
    QVERIFY(isNear(track.at(20.0).camera.position, {10.0F, 3.0F, 30.0F}));
    float least = 1e9F;
    float most = 0.0F;
    for (int i = 0; i < 200; ++i) {
        const float step = glm::distance(track.at(i * 0.1).camera.position,
                                         track.at((i + 1) * 0.1).camera.position);
        least = std::min(least, step);
        most = std::max(most, step);
    }
    QVERIFY2(most < 1.05F * least, qPrintable(QStringLiteral("%1 %2").arg(least).arg(most)));
    QVERIFY(isNear(track.at(20.0).camera.forward(), {0.0F, 0.0F, 1.0F}, 0.05F)); // ahead
    QCOMPARE(track.at(9.0).camera.fovYRadians, scene.cameras[0].camera.fovYRadians);
    scene.timeline[0].looksAhead = false;
    const Camera watching = CameraTrack(scene).at(20.0).camera;
    const glm::vec3 way = scene.cameras[0].camera.pivot() - watching.position;
    QVERIFY(isNear(watching.forward(), glm::normalize(way)));
}

void TestCameraTrack::aClosedWayEndsWhereItBegan()
{
    const CameraRail rail({{0, 0, 0}, {8, 0, 0}, {8, 0, 0}, {8, 0, 8}, {0, 0, 0}}, true);
    QVERIFY(!rail.isEmpty() && rail.length() > 27.0);
    QVERIFY(isNear(rail.at(0.0F).position, rail.at(1.0F).position));
    QVERIFY(isNear(rail.at(0.0F).direction, rail.at(1.0F).direction, 0.4F)); // no corner there
    const CameraRail way({{0, 0, 0}, {4, 0, 0}}, true); // there and back is none
    QVERIFY(isNear(way.at(1.0F).position, {4.0F, 0.0F, 0.0F}));
    QVERIFY(isNear(way.at(0.25F).position, {1.0F, 0.0F, 0.0F}));
    QVERIFY(CameraRail({{1, 1, 1}, {1, 1, 1}}, false).isEmpty());
    QVERIFY(CameraRail({}, true).isEmpty());
}

void TestCameraTrack::whatCannotBeIsSaidAndStays()
{
    Scene scene = stage();
    const auto flawed = [&scene](const Mark& mark) {
        scene.timeline = {mark};
        const CameraTrack track(scene);
        const Camera camera = track.at(3.0).camera;
        return !flawOf(scene, mark).empty() && camera == scene.cameras[0].camera;
    };
    QVERIFY(flawed(goTo(1.0, 1, "nobody's")));
    QVERIFY(flawed(goTo(1.0, 1, "")));
    Mark along = moveAt(1.0, 1, CameraMove::Along);
    QVERIFY(flawed(along));
    along.path = 3; // of one place
    QVERIFY(flawed(along));
    along.path = 1;
    QVERIFY(flawOf(scene, along).empty());
    QVERIFY(flawOf(scene, moveAt(1.0, 1, CameraMove::Around)).empty());
    QVERIFY(!doesAnything({along})); // to people
    scene.timeline = {goTo(2.0, 1, "Stalls"), goTo(2.0, 3, "Gallery"), goTo(4.0, 4, "nobody's"),
                      goTo(6.0, 7, "Stalls")};
    const auto flaws = flawsOfMarks(scene);
    QVERIFY(flaws.size() == 2 && flaws.contains(1) && flaws.contains(4));
    QVERIFY(flaws.at(1).english().find("twice") != std::string::npos);
    scene.cameras.clear();
    scene.timeline = {along};
    QVERIFY(std::isfinite(CameraTrack(scene).at(1.0).camera.position.x));
}

void TestCameraTrack::filesKeepIt()
{
    Scene scene = stage();
    Mark along = moveAt(1.0, 1, CameraMove::Along);
    along.path = 2;
    along.above = -2.5F;
    along.looksAhead = false;
    Mark around = moveAt(2.0, 2, CameraMove::Around);
    around.turn = -3.5F;
    around.isGentle = false;
    scene.timeline = {along, around, goTo(3.0, 3, "Gallery", 2.5F)};
    const auto read = projectFromText(projectText(scene));
    QVERIFY(read);
    QVERIFY(read.value().timeline == scene.timeline);
    QVERIFY(CameraTrack(read.value()).at(2.5) == CameraTrack(scene).at(2.5));
}

CROWD_TEST(TestCameraTrack)
#include "tst_CameraTrack.moc"
