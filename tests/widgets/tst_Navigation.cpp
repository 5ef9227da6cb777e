// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "tests/program/Test.h"
#include "tests/widgets/Hand.h"
#include "widgets/commands/ViewCommands.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Hand;
using crowd::testing::kCenter;

class TestNavigation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void middleAndAltNavigateWithAnyTool_data();
    void middleAndAltNavigateWithAnyTool();
    void escapeGoesBackToTheViewBefore();
    void spaceTappedPlaysAndHeldNavigates();
    void spaceWithAModifierIsTheWindows();
    void orbitStaysAboveTheGround();
    void wheelGoesTowardsThePointUnderTheCursor();
    void flyingNeedsItsModeForKeys();
    void bookmarksComeBack();
    void allIsPeoplePlacesAndTheStageWithoutItsHorizon();
};

void TestNavigation::middleAndAltNavigateWithAnyTool_data()
{
    QTest::addColumn<int>("tool");
    for (const ToolInfo& info : toolTable()) {
        QTest::newRow(info.stableId) << static_cast<int>(info.id);
    }
}

void TestNavigation::middleAndAltNavigateWithAnyTool()
{
    QFETCH(int, tool);
    Hand hand;
    hand.state.setTool(static_cast<ToolId>(tool));
    const auto movesTheView = [&](Qt::MouseButton button, Qt::KeyboardModifiers with) {
        const model::Camera before = hand.state.camera();
        hand.modifiers = with;
        hand.drag(kCenter, kCenter + QPointF(50.0, 20.0), button);
        return hand.state.camera() != before;
    };
    QVERIFY(movesTheView(Qt::MiddleButton, Qt::NoModifier));
    QVERIFY(movesTheView(Qt::MiddleButton, Qt::ShiftModifier));
    QVERIFY(movesTheView(Qt::MiddleButton, Qt::ControlModifier));
    QVERIFY(movesTheView(Qt::LeftButton, Qt::AltModifier));
    QVERIFY(movesTheView(Qt::RightButton, Qt::AltModifier));
    QVERIFY(hand.document.scene().population.isEmpty());
    QCOMPARE(hand.state.viewCamera().name, QString());
}

void TestNavigation::escapeGoesBackToTheViewBefore()
{
    Hand hand;
    const ViewCamera before = hand.state.viewCamera();
    QCOMPARE(before.name, QStringLiteral("front"));
    hand.press(kCenter, Qt::MiddleButton);
    hand.move(kCenter + QPointF(90.0, 20.0));
    QVERIFY(hand.state.camera() != before.camera);
    hand.key(Qt::Key_Escape);
    QVERIFY(hand.state.camera() == before.camera);
    QCOMPARE(hand.state.viewCamera().name, before.name);
}

void TestNavigation::spaceTappedPlaysAndHeldNavigates()
{
    Hand hand;
    hand.hover(kCenter);
    QVERIFY(!hand.state.transport().isPlaying());
    hand.key(Qt::Key_Space);
    QVERIFY(hand.state.transport().isPlaying());
    const model::Camera before = hand.state.camera();
    hand.tools.keyDown({Qt::Key_Space, Qt::NoModifier, false, hand.now()});
    hand.drag(kCenter, kCenter + QPointF(50.0, 0.0));
    hand.tools.keyUp({Qt::Key_Space, Qt::NoModifier, false, hand.now()});
    QVERIFY(hand.state.camera() != before);
    QVERIFY(hand.state.transport().isPlaying());
    QVERIFY(hand.document.scene().population.isEmpty());
    // The keyboard's repetition can look like a release and a press at one moment.
    hand.tools.keyDown({Qt::Key_Space, Qt::NoModifier, false, hand.now()});
    hand.drag(kCenter, kCenter + QPointF(50.0, 0.0));
    hand.letTimePass(1.0);
    hand.tools.keyUp({Qt::Key_Space, Qt::NoModifier, false, hand.now()});
    hand.tools.keyDown({Qt::Key_Space, Qt::NoModifier, false, hand.now()});
    hand.drag(kCenter, kCenter + QPointF(-50.0, 0.0));
    QVERIFY(hand.document.scene().population.isEmpty());
    hand.letTimePass(0.02);
    hand.tools.keyUp({Qt::Key_Space, Qt::NoModifier, false, hand.now()});
    QVERIFY(hand.state.transport().isPlaying());
    // Held long without moving is no tap either.
    hand.tools.keyDown({Qt::Key_Space, Qt::NoModifier, false, hand.now()});
    hand.letTimePass(2.0);
    hand.tools.keyUp({Qt::Key_Space, Qt::NoModifier, false, hand.now()});
    QVERIFY(hand.state.transport().isPlaying());
}

void TestNavigation::spaceWithAModifierIsTheWindows()
{
    Hand hand;
    hand.hover(kCenter);
    QVERIFY(hand.tools.claimsKey(Qt::Key_Space, Qt::NoModifier));
    QVERIFY(!hand.tools.claimsKey(Qt::Key_Space, Qt::ControlModifier));
    QVERIFY(!hand.tools.claimsKey(Qt::Key_Space, Qt::ShiftModifier));
    QVERIFY(!hand.key(Qt::Key_Space, Qt::ControlModifier));
    QVERIFY(!hand.state.transport().isPlaying());
    // Held already, it stays the tool's whatever else is pressed.
    hand.tools.keyDown({Qt::Key_Space, Qt::NoModifier, false, hand.now()});
    QVERIFY(hand.tools.claimsKey(Qt::Key_Space, Qt::ControlModifier));
}

void TestNavigation::orbitStaysAboveTheGround()
{
    Hand hand;
    hand.press(kCenter, Qt::MiddleButton);
    for (int i = 1; i <= 60; ++i) {
        hand.move(kCenter - QPointF(0.0, 10.0 * i));
        QVERIFY(hand.state.camera().position.y > 0.0F);
    }
    const model::Camera low = hand.state.camera();
    QVERIFY(low.position.y < 2.0F);
    hand.move(kCenter - QPointF(40.0, 600.0));
    QVERIFY(hand.state.camera() != low); // still turns
}

void TestNavigation::wheelGoesTowardsThePointUnderTheCursor()
{
    Hand hand;
    const QPointF at(420.0, 300.0);
    const glm::vec3 point = hand.tools.queries().pointUnder({at.x(), at.y()}, 0.0);
    const float before = glm::length(hand.state.camera().position - point);
    hand.tools.wheel({hand.at(at), 1.0});
    hand.tools.wheel({hand.at(at), 1.0});
    for (int frame = 0; frame < 30; ++frame) {
        hand.state.advance(1.0 / 60.0);
    }
    QVERIFY(hand.state.camera() == hand.state.cameraTarget());
    QVERIFY(glm::length(hand.state.camera().position - point) < before * 0.75F);
    const QPointF after = hand.pixelOf(point);
    QVERIFY((after - at).manhattanLength() < 1.0);
}

void TestNavigation::flyingNeedsItsModeForKeys()
{
    Hand hand;
    hand.hover(kCenter);
    const model::Camera before = hand.state.camera();
    hand.key(Qt::Key_W);
    hand.rest(0.2);
    QVERIFY(hand.state.camera() == before);
    QVERIFY(hand.key(Qt::Key_F, Qt::ShiftModifier));
    QVERIFY(hand.tools.isHandsFree());
    hand.tools.keyDown({Qt::Key_W, Qt::NoModifier, false, hand.now()});
    hand.rest(0.5);
    hand.tools.keyUp({Qt::Key_W, Qt::NoModifier, false, hand.now()});
    const glm::vec3 way = hand.state.camera().position - before.position;
    QVERIFY(glm::dot(way, before.forward()) > 1.0F);
    hand.press(kCenter);
    QVERIFY(!hand.tools.isDragging());
    hand.release(kCenter);
    QVERIFY(hand.document.scene().population.isEmpty());
    hand.key(Qt::Key_F, Qt::ShiftModifier);
    hand.move(kCenter + QPointF(80.0, 0.0));
    hand.key(Qt::Key_Escape);
    QVERIFY(!hand.tools.isDragging());
}

void TestNavigation::bookmarksComeBack()
{
    Hand hand;
    hand.drag(kCenter, kCenter + QPointF(90.0, 30.0), Qt::MiddleButton);
    const model::Camera here = hand.state.camera();
    const QString name = addCamera(hand.state);
    QVERIFY(!name.isEmpty());
    QCOMPARE(hand.document.scene().cameras.size(), std::size_t{2});
    goToCamera(hand.state, QStringLiteral("front"));
    for (int frame = 0; frame < 60; ++frame) {
        hand.state.advance(1.0 / 60.0);
    }
    QCOMPARE(hand.state.viewCamera().name, QStringLiteral("front"));
    QVERIFY(hand.state.camera() == hand.document.scene().cameras[0].camera);
    goToCamera(hand.state, name);
    hand.state.advance(1.0);
    QVERIFY(hand.state.camera() == here);
    QVERIFY(!renameCamera(hand.state, name, QStringLiteral("front")));
    QVERIFY(renameCamera(hand.state, name, QStringLiteral("side")));
    QVERIFY(addCamera(hand.state, QStringLiteral("side")) != QStringLiteral("side"));
    hand.document.undoStack().undo();
    hand.document.undoStack().undo();
    hand.document.undoStack().undo();
    QCOMPARE(hand.document.scene().cameras.size(), std::size_t{1});
}

void TestNavigation::allIsPeoplePlacesAndTheStageWithoutItsHorizon()
{
    model::Scene scene = testing::smallTheatre();
    auto stage = std::make_shared<model::StageAsset>(*scene.stages[0].asset);
    model::StageMesh detail;
    for (int i = 0; i < 1000; ++i) {
        detail.positions.emplace_back(0.02F * static_cast<float>(i) - 10.0F, 1.0F,
                                      static_cast<float>(i % 20));
    }
    model::StageMesh hills;
    for (int i = 0; i < 16; ++i) {
        hills.positions.emplace_back(i % 2 == 0 ? -400.0F : 400.0F, 30.0F,
                                     i % 4 < 2 ? -400.0F : 400.0F);
    }
    stage->meshes.push_back(detail);
    stage->meshes.push_back(hills);
    scene.stages[0].asset = stage;
    model::Bounds bounds = sceneBounds(scene);
    QVERIFY(bounds.low.x > -12.5F && bounds.low.x < -9.0F);
    QVERIFY(bounds.high.x < 12.5F && bounds.high.x > 9.0F);
    QVERIFY(bounds.high.z > 17.0F && bounds.high.z < 20.0F);
    scene.places.push_back({1, "far", {50.0F, 0.0F, 0.0F}, 5.0F});
    scene.population = testing::makeRow(2);
    bounds = sceneBounds(scene);
    QCOMPARE(bounds.high.x, 55.0F);
    QVERIFY(bounds.high.y > 1.5F);
    scene = {};
    QVERIFY(!sceneBounds(scene).isEmpty());
}

CROWD_TEST(TestNavigation)
#include "tst_Navigation.moc"
