// SPDX-License-Identifier: MIT
#include <cmath>

#include <QtTest/QTest>

#include "tests/model/BrushScene.h"
#include "tests/program/Test.h"

using namespace crowd::test;

class tst_BrushReach : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void rectangleShrinksBack();
    void deletesTheFrontmostOrAllThrough();
    void digsThroughWhileItDeletes();
    void selectsInTheShownKeyframe();
    void pressureScalesTheSize();
    void touchesNobodyOutsideTheCircle();
    void thinsOutByAShare();
};

void tst_BrushReach::rectangleShrinksBack()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{-2, 0, 0}, {2, 0, 0}});
    const View view = fromAbove();
    const auto at = [&](float x, float z) {
        return PointerInput::at(pixelOf(view, {x, 0, z}), 0.0);
    };
    const auto stroke = Stroke::begin(scene.document, scene.context(view),
                                      colourBrush(BrushSelection::Rectangle), 1, at(-3, -1));
    stroke->move(at(3, 1));
    QCOMPARE(stroke->affected(), 2);
    stroke->move(at(0, 1));
    QCOMPARE(stroke->affected(), 1);
    QCOMPARE(tintOf(scene, ids[1], 1), Tint{});
    QCOMPARE(stroke->finish().affected, 1);
}

void tst_BrushReach::deletesTheFrontmostOrAllThrough()
{
    const auto leftAfter = [](bool through) {
        BrushScene scene;
        scene.addPeople({{0, 0, 2}, {0, 0, 0}, {0, 0, -2}, {3, 0, 0}});
        BrushSettings settings = brush(BrushKind::Delete, BrushSelection::Point);
        settings.through = through;
        const View view = fromFront();
        scene.paint(view, settings, {pixelOf(view, {0, 1, 0})});
        return Ids(scene.people().ids().begin(), scene.people().ids().end());
    };
    QCOMPARE(leftAfter(false), (Ids{2, 3, 4}));
    QCOMPARE(leftAfter(true), (Ids{4}));
}

void tst_BrushReach::digsThroughWhileItDeletes()
{
    BrushScene scene;
    scene.addPeople({{0, 0, 2}, {0, 0, 0}, {0, 0, -2}});
    BrushSettings settings = brush(BrushKind::Delete, BrushSelection::Spray);
    settings.radiusPixels = 2.0F;
    settings.ratePerSecond = 10.0F;
    const View view = fromFront();
    const glm::dvec2 at = pixelOf(view, {0, 1, 0});
    const auto outcome = scene.paint(view, settings, std::vector<glm::dvec2>(5, at));
    // The press takes one, the two points of the next 0.2 s one each.
    QCOMPARE(outcome.affected, 3);
    QVERIFY(scene.people().isEmpty());
}

void tst_BrushReach::selectsInTheShownKeyframe()
{
    // Lies down over its second: the body is where it is shown, not where it was at the start.
    auto man = std::make_shared<Template>(*boxMan());
    Channel turn;
    turn.path = ChannelPath::Rotation;
    turn.times = {0.0F, 1.0F};
    turn.values = {0, 0, 0, 1, std::sqrt(0.5F), 0, 0, std::sqrt(0.5F)};
    man->clips[0].channels.push_back(turn);
    BrushScene scene;
    scene.replaceMan(man);
    scene.addPeople({{0, 0, 0}});
    (void)scene.keyframes.clip(man, 0);
    scene.keyframes.waitForAll();
    BrushSettings settings = colourBrush(BrushSelection::Point);
    const View view = fromAbove();
    const auto affectedAt = [&](double seconds) {
        const auto stroke =
            Stroke::begin(scene.document, scene.context(view), settings, 1,
                          PointerInput::at(pixelOf(view, {0.0F, 0.0F, 1.5F}), 0.0, seconds));
        const int affected = stroke->affected();
        stroke->cancel();
        return affected;
    };
    QCOMPARE(affectedAt(0.0), 0);
    QCOMPARE(affectedAt(0.95), 1);
    QCOMPARE(affectedAt(4.95), 1);
    QCOMPARE(affectedAt(5.05), 0);
}

void tst_BrushReach::pressureScalesTheSize()
{
    const auto affectedAt = [](float pressure) {
        BrushScene scene;
        scene.addPeople(crowdGrid());
        BrushSettings settings = colourBrush(BrushSelection::AllInCircle);
        settings.radiusPixels = 300.0F;
        settings.pressureSize = true;
        PointerInput press = PointerInput::at(pixelOf(fromAbove(), {0.5F, 0, 0.5F}), 0.0);
        press.pressure = pressure;
        return Stroke::begin(scene.document, scene.context(fromAbove()), settings, 1, press)
            ->affected();
    };
    QCOMPARE(affectedAt(0.05F), 1);
    QVERIFY(affectedAt(1.0F) > 40);
}

void tst_BrushReach::touchesNobodyOutsideTheCircle()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    BrushSettings settings = brush(BrushKind::Delete, BrushSelection::Spray);
    settings.radiusPixels = 128.0F;
    settings.ratePerSecond = 500.0F;
    const View view = fromAbove();
    const glm::dvec2 at = pixelOf(view, {0, 0, 0});
    std::vector<glm::dvec2> still(60, at);
    QVERIFY(scene.paint(view, settings, still).affected > 8);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        // 128 pixels are 2 m; half the width of a man comes on top.
        if (glm::length(crowdGrid()[i]) > 2.0F + 0.3F) {
            QVERIFY(scene.people().rowOf(ids[i]) != Population::npos);
        }
    }
}

void tst_BrushReach::thinsOutByAShare()
{
    BrushScene scene;
    scene.addPeople(crowdGrid());
    BrushSettings settings = brush(BrushKind::Delete, BrushSelection::Rectangle);
    settings.as<DeleteSettings>().percent = 50.0F;
    const StrokeOutcome half = scene.paint(fromAbove(), settings, {{100, 50}, {1200, 700}});
    QVERIFY2(half.affected > 18 && half.affected < 42, qPrintable(QString::number(half.affected)));
    settings.selection = BrushSelection::AllInCircle;
    settings.radiusPixels = 1000.0F;
    settings.as<DeleteSettings>().percent = 100.0F;
    QCOMPARE(scene.paint(fromAbove(), settings, {{640, 384}}).affected, 60 - half.affected);
    settings.as<DeleteSettings>().percent = 0.0F;
    scene.addPeople({{0, 0, 0}});
    const StrokeOutcome nobody = scene.paint(fromAbove(), settings, {{640, 384}});
    QVERIFY(nobody.reason == StrokeReason::ShareTooSmall && !nobody.message.isEmpty());
}

CROWD_TEST(tst_BrushReach)
#include "tst_BrushReach.moc"
