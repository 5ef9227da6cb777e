// SPDX-License-Identifier: MIT
#include "model/pick/ScenePicker.h"

#include <cmath>
#include <set>

#include <QtTest/QTest>

#include "model/base/Random.h"

#include "tests/model/BrushScene.h"
#include "tests/program/Test.h"

using namespace crowd::test;

namespace {

StageEntry wallAt(float z)
{
    return stageOf({plate({glm::vec3(-5.0F, 0.0F, z), glm::vec3(5.0F, 0.0F, z),
                           glm::vec3(5.0F, 3.0F, z), glm::vec3(-5.0F, 3.0F, z)})});
}

struct Picking
{
    explicit Picking(BrushScene& scene, const View& view, double seconds = 0.0)
        : picker(scene.keyframes, scene.rays)
    {
        const std::vector<WorldSeat> seats = scene.document.scene().worldSeats();
        picker.update(scene.document.frame(seconds), seats, view);
    }
    ScenePicker picker;
};

} // namespace

class tst_PickScene : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsGroundAndStage();
    void seesWhatBlocks();
    void listsSurfacesFromTheTop();
    void followsAMovedStage();
    void picksTheNearest();
    void doesNotPickBesideTheShape();
    void doesNotPickBehindTheStage();
    void liftsTheSeated();
    void takesVisibleOrAllInAnArea();
    void hidesThoseBehindTheStage();
    void takesShapesNotBoxes();
    void agreesWithPickingPixelByPixel();
    void leavesOutTheExcluded();
    void costsWhatIsInside();
};

void tst_PickScene::findsGroundAndStage()
{
    BrushScene scene({stageOf({plate(
        {glm::vec3(-1, 2, -1), glm::vec3(-1, 2, 1), glm::vec3(1, 2, 1), glm::vec3(1, 2, -1)})})});
    const auto onPlate = scene.rays.hit({{0.5F, 9.0F, 0.5F}, {0.0F, -1.0F, 0.0F}});
    QVERIFY(onPlate);
    QCOMPARE(onPlate->point.y, 2.0F);
    QCOMPARE(onPlate->normal.y, 1.0F);
    QVERIFY(!onPlate->isGround);
    const auto onGround = scene.rays.hit({{3.0F, 9.0F, 0.5F}, {0.0F, -1.0F, 0.0F}});
    QVERIFY(onGround && onGround->isGround);
    QCOMPARE(onGround->distance, 9.0F);
    QVERIFY(!scene.rays.hit({{3.0F, 9.0F, 0.5F}, {0.0F, 1.0F, 0.0F}}));
}

void tst_PickScene::seesWhatBlocks()
{
    BrushScene scene({wallAt(0.0F)});
    QVERIFY(scene.rays.isBlocked({0.0F, 1.0F, 5.0F}, {0.0F, 1.0F, -5.0F}));
    QVERIFY(!scene.rays.isBlocked({0.0F, 1.0F, 5.0F}, {0.0F, 1.0F, 0.0F}));
    QVERIFY(!scene.rays.isBlocked({0.0F, 6.0F, 5.0F}, {0.0F, 6.0F, -5.0F}));
}

void tst_PickScene::listsSurfacesFromTheTop()
{
    const auto floorAt = [](float y) {
        return plate(
            {glm::vec3(-1, y, -1), glm::vec3(-1, y, 1), glm::vec3(1, y, 1), glm::vec3(1, y, -1)});
    };
    BrushScene scene({stageOf({floorAt(1.0F), floorAt(4.0F)})});
    std::vector<float> heights;
    for (const SurfaceHit& surface : scene.rays.below({0.0F, 10.0F, 0.0F})) {
        heights.push_back(std::round(surface.point.y * 1000.0F) / 1000.0F);
    }
    QCOMPARE(heights, (std::vector<float>{4.0F, 1.0F, 0.0F}));
}

void tst_PickScene::followsAMovedStage()
{
    BrushScene scene({wallAt(0.0F)});
    StageEntry moved = scene.document.scene().stages.front();
    moved.position.z = -3.0F;
    const std::uint64_t before = scene.rays.version();
    scene.rays.setStages(scene.document.scene().stages);
    QCOMPARE(scene.rays.version(), before);
    scene.rays.setStages({&moved, 1});
    QVERIFY(scene.rays.version() > before);
    QCOMPARE(scene.rays.hit({{0.0F, 1.0F, 5.0F}, {0.0F, 0.0F, -1.0F}})->distance, 8.0F);
}

void tst_PickScene::picksTheNearest()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, -2}, {0, 0, 2}, {3, 0, 0}});
    const View view = fromFront();
    Picking picking(scene, view);
    const auto hit = picking.picker.individualAt(pixelOf(view, {0.0F, 1.0F, 0.0F}));
    QVERIFY(hit);
    QCOMPARE(hit->id, ids[1]);
    QVERIFY(std::abs(hit->point.z - 2.15F) < 0.001F);
    QCOMPARE(hit->slot, 0);
    const auto fromSide = picking.picker.individualAt(pixelOf(view, {2.75F, 1.0F, 0.1F}));
    QVERIFY(fromSide);
    QCOMPARE(fromSide->slot, 2);
    const auto all = picking.picker.individualsThrough(pixelOf(view, {0.0F, 1.0F, 0.0F}));
    QCOMPARE(all.size(), std::size_t{2});
    QCOMPARE(all[1].id, ids[0]);
}

void tst_PickScene::doesNotPickBesideTheShape()
{
    BrushScene scene;
    scene.addPeople({{0, 0, 0}});
    const View view = fromFront();
    Picking picking(scene, view);
    QVERIFY(picking.picker.individualAt(pixelOf(view, {0.24F, 1.0F, 0.15F})));
    QVERIFY(!picking.picker.individualAt(pixelOf(view, {0.27F, 1.0F, 0.15F})));
    QVERIFY(!picking.picker.individualAt(pixelOf(view, {0.0F, 1.9F, 0.15F})));
}

void tst_PickScene::doesNotPickBehindTheStage()
{
    BrushScene scene({wallAt(1.0F)});
    const Ids ids = scene.addPeople({{0, 0, 0}, {2, 0, 3}});
    const View view = fromFront();
    Picking picking(scene, view);
    QVERIFY(!picking.picker.individualAt(pixelOf(view, {0.0F, 1.0F, 0.0F})));
    QCOMPARE(picking.picker.individualAt(pixelOf(view, {2.0F, 1.0F, 3.0F}))->id, ids[1]);
    QCOMPARE(picking.picker.individualsThrough(pixelOf(view, {0.0F, 1.0F, 0.0F})).size(),
             std::size_t{1});
}

void tst_PickScene::liftsTheSeated()
{
    Seat seat;
    seat.height = 1.45F;
    BrushScene scene({stageOf({}, {seat})});
    const Ids ids = scene.addPeople({{0, 0, 0}});
    const auto edit = scene.document.beginEdit().value();
    const SeatId seatId = scene.document.scene().worldSeats().front().id;
    const std::uint16_t sit = 1;
    edit->setColumn(columns::seat, ids, std::span(&seatId, 1));
    edit->setColumn(columns::clip, ids, std::span(&sit, 1));
    edit->commit(QStringLiteral("Sit"));
    const View view = fromFront();
    Picking picking(scene, view);
    QVERIFY(picking.picker.individualAt(pixelOf(view, {0.0F, 2.7F, 0.15F})));
    QVERIFY(!picking.picker.individualAt(pixelOf(view, {0.0F, 0.9F, 0.15F})));
}

void tst_PickScene::takesVisibleOrAllInAnArea()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 2}, {0, 0, 0}, {0.4F, 0, -1}, {3, 0, 0}});
    const View view = fromFront();
    Picking picking(scene, view);
    const auto area = ScreenArea::circle(pixelOf(view, {0.0F, 1.0F, 2.0F}), 60.0);
    QCOMPARE(picking.picker.individualsInArea(area, AreaMode::Visible), (Ids{ids[0], ids[2]}));
    QCOMPARE(picking.picker.individualsInArea(area, AreaMode::Through),
             (Ids{ids[0], ids[1], ids[2]}));
    const auto corner = ScreenArea::rectangle({0.0, 0.0}, {40.0, 40.0});
    QVERIFY(picking.picker.individualsInArea(corner, AreaMode::Through).empty());
}

void tst_PickScene::hidesThoseBehindTheStage()
{
    BrushScene scene({wallAt(1.0F)});
    const Ids ids = scene.addPeople({{0, 0, 0}, {0, 2.5F, 0}});
    const View view = fromFront();
    Picking picking(scene, view);
    const auto all = ScreenArea::rectangle({0.0, 0.0}, {1280.0, 768.0});
    QCOMPARE(picking.picker.individualsInArea(all, AreaMode::Visible), (Ids{ids[1]}));
    QCOMPARE(picking.picker.individualsInArea(all, AreaMode::Through), ids);
}

void tst_PickScene::takesShapesNotBoxes()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 0}});
    const View view = fromFront();
    Picking picking(scene, view);
    // The cylinder that holds all headings is wider than the man seen from the front.
    const glm::dvec2 beside = pixelOf(view, {0.275F, 1.0F, 0.15F});
    const auto dot = ScreenArea::circle(beside, 0.6);
    QVERIFY(picking.picker.individualsInArea(dot, AreaMode::Through).empty());
    QVERIFY(picking.picker.individualsInArea(dot, AreaMode::Visible).empty());
    const auto dab = ScreenArea::circle(beside, 4.0);
    QCOMPARE(picking.picker.individualsInArea(dab, AreaMode::Through), ids);
    QCOMPARE(picking.picker.individualsInArea(dab, AreaMode::Visible), ids);
}

void tst_PickScene::agreesWithPickingPixelByPixel()
{
    BrushScene scene({wallAt(-1.5F)});
    std::vector<glm::vec3> positions;
    for (std::uint64_t i = 0; i < 60; ++i) {
        positions.emplace_back(8.0F * unitFloat(hashKeys(i, 1)) - 4.0F, 0.0F,
                               6.0F * unitFloat(hashKeys(i, 2)) - 4.0F);
    }
    scene.addPeople(positions);
    const View view(Camera::lookingAt({0.0F, 2.5F, 9.0F}, {0.0F, 1.0F, 0.0F}), {320.0F, 200.0F});
    Picking picking(scene, view);
    const auto area = ScreenArea::rectangle({100.0, 60.0}, {180.0, 140.0});
    std::set<IndividualId> seen;
    for (int y = 60; y < 140; ++y) {
        for (int x = 100; x < 180; ++x) {
            if (const auto hit = picking.picker.individualAt({x + 0.5, y + 0.5})) {
                seen.insert(hit->id);
            }
        }
    }
    QVERIFY(seen.size() > 10);
    QVERIFY(seen.size() < 60);
    QCOMPARE(picking.picker.individualsInArea(area, AreaMode::Visible),
             Ids(seen.begin(), seen.end()));
}

void tst_PickScene::leavesOutTheExcluded()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 2}, {0, 0, 0}});
    const View view = fromFront();
    Picking picking(scene, view);
    const glm::dvec2 pixel = pixelOf(view, {0.0F, 1.0F, 2.0F});
    picking.picker.exclude(std::array{ids[0]});
    QCOMPARE(picking.picker.individualAt(pixel)->id, ids[1]);
    QCOMPARE(picking.picker.individualsInArea(ScreenArea::circle(pixel, 5.0), AreaMode::Visible),
             (Ids{ids[1]}));
}

void tst_PickScene::costsWhatIsInside()
{
    // The same 100 people under the brush, among 1000 and among 100 000.
    const auto visitsAmong = [](int others) {
        BrushScene scene;
        std::vector<glm::vec3> positions;
        for (int i = 0; i < 100; ++i) {
            positions.emplace_back(0.05F * static_cast<float>(i % 10), 0.0F,
                                   0.05F * static_cast<float>(i / 10));
        }
        for (int i = 0; i < others; ++i) {
            positions.emplace_back(3.0F + 6.0F * unitFloat(hashKeys(i, 1)), 0.0F,
                                   6.0F * unitFloat(hashKeys(i, 2)) - 3.0F);
        }
        scene.addPeople(positions);
        const View view = fromAbove();
        Picking picking(scene, view);
        const auto area = ScreenArea::circle(pixelOf(view, {0.2F, 0.0F, 0.2F}), 40.0);
        const std::uint64_t before = picking.picker.candidateVisits();
        const Ids inside = picking.picker.individualsInArea(area, AreaMode::Through);
        const bool isRight = inside.size() == 100;
        return isRight ? picking.picker.candidateVisits() - before : 0;
    };
    const std::uint64_t few = visitsAmong(1000);
    QVERIFY(few >= 100);
    QCOMPARE(visitsAmong(100000), few);
}

CROWD_TEST(tst_PickScene)
#include "tst_PickScene.moc"
