// SPDX-License-Identifier: MIT
#include <cmath>

#include "model/pick/ScenePicker.h"
#include "tests/model/BrushScene.h"
#include "tests/program/Test.h"

using namespace crowd::test;

namespace {

using Corners = std::vector<glm::dvec2>;

/// Whom a lasso round these points of the ground finds, from above.
Ids found(BrushScene& scene, const std::vector<glm::vec3>& around, AreaMode mode)
{
    const View view = fromAbove();
    Corners corners;
    for (const glm::vec3& point : around) {
        corners.push_back(pixelOf(view, point));
    }
    ScenePicker picker(scene.keyframes, scene.rays);
    picker.update(scene.document.frame(0.0), {}, view);
    return picker.individualsInArea(ScreenArea::polygon(corners), mode);
}

} // namespace

class tst_Lasso : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void holdsWhatItGoesRound();
    void crossesItself();
    void ofManyCornersAsksFewOfThem();
    void withFewCornersHoldsNobody();
    void leavesOutWhoStandsInABay();
    void paintsOnThemAlone();
    void fillsItsInsideWithNewOnes();
};

void tst_Lasso::holdsWhatItGoesRound()
{
    const ScreenArea area = ScreenArea::polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    QVERIFY(area.contains({5, 5}) && area.contains({0.5, 9.5}));
    QVERIFY(!area.contains({-1, 5}) && !area.contains({11, 5}) && !area.contains({5, 11}));
    const ScreenArea back = ScreenArea::polygon({{0, 10}, {10, 10}, {10, 0}, {0, 0}});
    QVERIFY(back.contains({5, 5}) && !back.contains({5, 11}));
}

void tst_Lasso::crossesItself()
{
    const ScreenArea eight = ScreenArea::polygon({{0, 0}, {10, 10}, {10, 0}, {0, 10}});
    QVERIFY(eight.contains({1, 5}) && eight.contains({9, 5}));
    QVERIFY(!eight.contains({5, 1}) && !eight.contains({5, 9}));
    // Twice round the same way: no hole in the middle.
    const ScreenArea twice =
        ScreenArea::polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}, {8, 2}, {8, 8}, {2, 8}});
    QVERIFY(twice.contains({5, 5}));
}

/// The winding number by all edges, as the area had it before it sorted them.
bool windsRound(const Corners& corners, glm::dvec2 point)
{
    int turns = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 a = corners[i];
        const glm::dvec2 b = corners[(i + 1) % corners.size()];
        const double side = (b.x - a.x) * (point.y - a.y) - (point.x - a.x) * (b.y - a.y);
        turns += a.y <= point.y && b.y > point.y && side > 0.0 ? 1 : 0;
        turns -= a.y > point.y && b.y <= point.y && side < 0.0 ? 1 : 0;
    }
    return turns != 0;
}

void tst_Lasso::ofManyCornersAsksFewOfThem()
{
    const auto jagged = [](int corners) {
        Corners all;
        for (int i = 0; i < corners; ++i) {
            const double angle = 6.283185307179586 * i / corners;
            const double radius = 200.0 + 100.0 * std::sin(angle * 41.0) + 3.0 * (i % 5);
            all.push_back(
                {300.0 + radius * std::cos(angle * 2.0), 300.0 + radius * std::sin(angle)});
        }
        return all;
    };
    const Corners few = jagged(997);
    const ScreenArea area = ScreenArea::polygon(few);
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec2 point(i * 37 % 700 - 50 + (i % 3) * 0.25,
                               i * 101 % 700 - 50 + (i % 2) * 0.5);
        QCOMPARE(area.contains(point), windsRound(few, point));
    }
    for (const glm::dvec2& corner : few) {
        QCOMPARE(area.contains(corner), windsRound(few, corner));
    }
    const ScreenArea large = ScreenArea::polygon(jagged(100000));
    const Corners many = jagged(100000);
    for (int i = 0; i < 40; ++i) {
        const glm::dvec2 point(i * 37 % 600, i * 101 % 600);
        QCOMPARE(large.contains(point), windsRound(many, point));
    }
}

void tst_Lasso::withFewCornersHoldsNobody()
{
    BrushScene scene;
    scene.addPeople(crowdGrid());
    for (const std::vector<glm::vec3>& around :
         {std::vector<glm::vec3>{}, {{0, 0, 0}}, {{-3, 0, 0}, {3, 0, 0}}}) {
        QVERIFY(found(scene, around, AreaMode::Through).empty());
        QVERIFY(found(scene, around, AreaMode::Visible).empty());
    }
}

void tst_Lasso::leavesOutWhoStandsInABay()
{
    BrushScene scene;
    // Round the left, the right and the lower one; the upper one stands in the bay between.
    const Ids ids = scene.addPeople({{-2, 0, 0}, {2, 0, 0}, {0, 0, 2}, {0, 0, -1}});
    const std::vector<glm::vec3> around{{-3, 0, -2}, {-1, 0, -2}, {-1, 0, 1}, {1, 0, 1},
                                        {1, 0, -2},  {3, 0, -2},  {3, 0, 3},  {-3, 0, 3}};
    const Ids wanted{ids[0], ids[1], ids[2]};
    QCOMPARE(found(scene, around, AreaMode::Through), wanted);
    QCOMPARE(found(scene, around, AreaMode::Visible), wanted);
}

void tst_Lasso::paintsOnThemAlone()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{-2, 0, 0}, {2, 0, 0}});
    const View view = fromAbove();
    BrushSettings settings = colourBrush(BrushSelection::Lasso);
    const Corners way{pixelOf(view, {-3, 0, -1}), pixelOf(view, {-1, 0, -1}),
                      pixelOf(view, {-1, 0, 1}), pixelOf(view, {-3, 0, 1})};
    QCOMPARE(scene.paint(view, settings, way).affected, 1);
    QVERIFY(!(tintOf(scene, ids[0], 1) == Tint{}));
    QVERIFY(tintOf(scene, ids[1], 1) == Tint{});
    QCOMPARE(scene.paint(view, settings, {{100, 100}, {120, 100}}).reason,
             StrokeReason::NobodyUnderBrush);
}

void tst_Lasso::fillsItsInsideWithNewOnes()
{
    BrushScene scene;
    const View view = fromAbove();
    BrushSettings settings = brush(BrushKind::Create, BrushSelection::Lasso);
    settings.as<CreateSettings>().density = 2.0F;
    settings.as<CreateSettings>().minimalDistance = 0.3F;
    const Corners way{pixelOf(view, {-4, 0, -4}), pixelOf(view, {4, 0, -4}),
                      pixelOf(view, {-4, 0, 4})};
    QVERIFY(scene.paint(view, settings, way).affected > 30);
    for (const glm::vec3& at : scene.people().column(columns::position)) {
        QVERIFY2(at.x + at.z < 0.01F && at.x > -4.01F && at.z > -4.01F, "in the triangle");
    }
}

CROWD_TEST(tst_Lasso)
#include "tst_Lasso.moc"
