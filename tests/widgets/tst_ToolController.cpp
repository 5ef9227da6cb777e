// SPDX-License-Identifier: MIT
#include <optional>

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include "model/brush/Stroke.h"
#include "tests/program/Test.h"
#include "tests/widgets/Hand.h"
#include "widgets/state/EditorState.h"
#include "widgets/tools/BrushTool.h"
#include "widgets/tools/ToolController.h"
#include "widgets/viewport/ViewCommands.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Hand;

namespace {

constexpr QPointF kCenter(320.0, 240.0);

} // namespace

class TestToolController : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void clickSelectsAndEmptyGroundClears();
    void modifiersAddAndToggle();
    void rectangleSelectsWhatIsInside();
    void withShiftARectangleBeginsOnSomebodyToo();
    void escapeKeepsTheSelectionOfBefore();
    void selectionForgetsWhoVanishes();
    void deleteRemovesTheSelectedInOneStep();
    void draggingSomebodyMovesThemInOneStep();

    void aStrokeIsOneUndoStep();
    void escapeTakesTheStrokeBack();
    void aStillButtonGoesOnSpraying();
    void anEmptyStrokeSaysWhy();
    void aRectangleFollowsThePointerFrameByFrame();
    void theGhostGoesWhenItsTemplateDoes();
    void changingTheToolTakesTheStrokeBack();
    void ghostStandsUnderTheCreationBrush();
    void paperMappingGivesEachButtonItsSelection_data();
    void paperMappingGivesEachButtonItsSelection();
    void rightButtonAsksForThePalette();

    void keysChangeSizeAndMainNumber();
    void wheelWithControlResizes();
    void shiftDragResizesAndEscapeRestores();

    void middleAndAltNavigateWithAnyTool_data();
    void middleAndAltNavigateWithAnyTool();
    void escapeGoesBackToTheViewBefore();
    void spaceTappedPlaysAndHeldNavigates();
    void spaceWithAModifierIsTheWindows();
    void orbitStaysAboveTheGround();
    void wheelGoesTowardsThePointUnderTheCursor();
    void flyingNeedsItsModeForKeys();
    void keysDoNothingElseInTheMiddleOfADrag();
    void lateEventsNeverTurnTimeBack();
    void bookmarksComeBack();
};

void TestToolController::clickSelectsAndEmptyGroundClears()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 3);
    hand.state.setTool(ToolId::Select);
    hand.drag(hand.pixelOf(ids[1]), hand.pixelOf(ids[1]));
    QCOMPARE(hand.state.selection().size(), std::size_t{1});
    QVERIFY(hand.state.selection().contains(ids[1]));
    hand.drag({5.0, 470.0}, {5.0, 470.0});
    QVERIFY(hand.state.selection().isEmpty());
    QCOMPARE(hand.document.undoStack().count(), 1);
}

void TestToolController::modifiersAddAndToggle()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 3);
    hand.state.setTool(ToolId::Select);
    hand.drag(hand.pixelOf(ids[0]), hand.pixelOf(ids[0]));
    hand.modifiers = Qt::ShiftModifier;
    hand.drag(hand.pixelOf(ids[2]), hand.pixelOf(ids[2]));
    hand.drag(hand.pixelOf(ids[2]), hand.pixelOf(ids[2]));
    QCOMPARE(hand.state.selection().size(), std::size_t{2});
    hand.modifiers = Qt::ControlModifier;
    hand.drag(hand.pixelOf(ids[0]), hand.pixelOf(ids[0]));
    QCOMPARE(hand.state.selection().size(), std::size_t{1});
    QVERIFY(hand.state.selection().contains(ids[2]));
    // Empty ground with a modifier held is a slip of the hand, not a wish to lose the selection.
    hand.drag({5.0, 470.0}, {5.0, 470.0});
    QCOMPARE(hand.state.selection().size(), std::size_t{1});
}

void TestToolController::withShiftARectangleBeginsOnSomebodyToo()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 4);
    hand.state.setTool(ToolId::Select);
    hand.state.selection().set(std::vector{ids[3]});
    const int steps = hand.document.undoStack().count();
    hand.modifiers = Qt::ShiftModifier;
    hand.drag(hand.pixelOf(ids[0]), hand.pixelOf(ids[1]) + QPointF(2.0, 30.0));
    QVERIFY2(hand.document.undoStack().count() == steps, "nobody is moved");
    QCOMPARE(hand.state.selection().size(), std::size_t{3});
    QVERIFY(!hand.state.selection().contains(ids[2]));
    hand.modifiers = Qt::NoModifier;
    hand.drag(hand.pixelOf(ids[2]), hand.pixelOf(ids[2]) + QPointF(0.0, 60.0));
    QCOMPARE(hand.document.undoStack().count(), steps + 1);
    QVERIFY2(hand.state.selection().size() == 1, "who is dragged and was not selected goes alone");
}

void TestToolController::rectangleSelectsWhatIsInside()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 6);
    hand.state.setTool(ToolId::Select);
    const QPointF first = hand.pixelOf(ids[1]);
    const QPointF last = hand.pixelOf(ids[4]);
    hand.press(first + QPointF(-12.0, -90.0));
    hand.move(last + QPointF(12.0, 60.0));
    QVERIFY(hand.tools.picture().rectangle.has_value());
    hand.release(last + QPointF(12.0, 60.0));
    const auto selected = hand.state.selection().ids();
    QCOMPARE(std::vector<model::IndividualId>(selected.begin(), selected.end()),
             (std::vector<model::IndividualId>{ids[1], ids[2], ids[3], ids[4]}));
    QVERIFY(!hand.tools.isDragging());
}

void TestToolController::escapeKeepsTheSelectionOfBefore()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 3);
    hand.state.setTool(ToolId::Select);
    hand.state.selection().set(ids);
    hand.press({5.0, 470.0});
    hand.move({500.0, 20.0});
    hand.key(Qt::Key_Escape);
    QVERIFY(!hand.tools.isDragging());
    hand.release({500.0, 20.0});
    QCOMPARE(hand.state.selection().size(), std::size_t{3});
    hand.key(Qt::Key_Escape);
    QVERIFY(hand.state.selection().isEmpty());
}

void TestToolController::selectionForgetsWhoVanishes()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 3);
    hand.state.selection().set(ids);
    QSignalSpy changes(&hand.state.selection(), &Selection::changed);
    auto edit = hand.document.beginEdit();
    edit->removeIndividuals(std::vector{ids[0], ids[2]});
    edit->commit(QStringLiteral("remove"));
    QCOMPARE(hand.state.selection().size(), std::size_t{1});
    QVERIFY(changes.count() >= 1);
    hand.state.selection().apply(std::vector{ids[0]}, SelectionMode::Add);
    QCOMPARE(hand.state.selection().size(), std::size_t{1});
    hand.document.replaceScene(testing::smallTheatre(), {});
    QVERIFY(hand.state.selection().isEmpty());
}

void TestToolController::deleteRemovesTheSelectedInOneStep()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 5);
    hand.state.selection().set(std::vector{ids[0], ids[3]});
    QVERIFY(hand.key(Qt::Key_Delete));
    QCOMPARE(hand.document.scene().population.size(), std::size_t{3});
    QCOMPARE(hand.document.undoStack().count(), 2);
    hand.document.undoStack().undo();
    QCOMPARE(hand.document.scene().population.size(), std::size_t{5});
    hand.state.selection().clear();
    QSignalSpy remarks(&hand.state, &EditorState::statusMessage);
    hand.key(Qt::Key_Delete);
    QCOMPARE(remarks.count(), 1);
    QCOMPARE(hand.document.undoStack().index(), 1);
}

void TestToolController::draggingSomebodyMovesThemInOneStep()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 2);
    hand.state.setSeatGridOn(false);
    hand.state.setTool(ToolId::Select);
    const auto positions = [&] {
        const auto column = hand.document.scene().population.column(model::columns::position);
        return std::vector<glm::vec3>(column.begin(), column.end());
    };
    const auto before = positions();
    const QPointF from = hand.pixelOf(ids[0]);
    hand.drag(from, from + QPointF(-60.0, 10.0));
    QVERIFY(positions()[0].x < before[0].x - 0.5F);
    QCOMPARE(positions()[1].x, before[1].x);
    QVERIFY(hand.state.selection().contains(ids[0]));
    QCOMPARE(hand.document.undoStack().count(), 2);
    hand.press(hand.pixelOf(ids[0]));
    hand.move(hand.pixelOf(ids[0]) + QPointF(100.0, 0.0));
    hand.key(Qt::Key_Escape);
    QCOMPARE(hand.document.undoStack().count(), 2);
    hand.document.undoStack().undo();
    QVERIFY(positions() == before);
}

void TestToolController::aStrokeIsOneUndoStep()
{
    Hand hand;
    hand.state.setTool(ToolId::BrushCreate);
    hand.press(kCenter);
    QVERIFY(hand.tools.isDragging());
    for (int step = 0; step < 40; ++step) {
        hand.move(kCenter + QPointF(step * 3.0, 0.0));
    }
    hand.release(kCenter + QPointF(120.0, 0.0));
    QVERIFY(!hand.tools.isDragging());
    QVERIFY(!hand.document.isEditOpen());
    const std::size_t created = hand.document.scene().population.size();
    QVERIFY(created > 3);
    QCOMPARE(hand.document.undoStack().count(), 1);
    hand.document.undoStack().undo();
    QVERIFY(hand.document.scene().population.isEmpty());
    hand.document.undoStack().redo();
    QCOMPARE(hand.document.scene().population.size(), created);
}

void TestToolController::escapeTakesTheStrokeBack()
{
    Hand hand;
    hand.press(kCenter);
    for (int step = 0; step < 20; ++step) {
        hand.move(kCenter + QPointF(step * 3.0, 0.0));
    }
    QVERIFY(!hand.document.scene().population.isEmpty());
    QVERIFY(hand.key(Qt::Key_Escape));
    QVERIFY(hand.document.scene().population.isEmpty());
    QCOMPARE(hand.document.undoStack().count(), 0);
    // The button that is still down paints no more.
    hand.move(kCenter);
    hand.release(kCenter);
    QVERIFY(hand.document.scene().population.isEmpty());
    QVERIFY(!hand.document.isEditOpen());
}

void TestToolController::aStillButtonGoesOnSpraying()
{
    Hand hand;
    hand.hover(kCenter);
    hand.press(kCenter);
    const std::size_t atOnce = hand.document.scene().population.size();
    hand.rest(1.0);
    QVERIFY(hand.document.scene().population.size() > atOnce + 2);
    hand.release(kCenter);
    QCOMPARE(hand.document.undoStack().count(), 1);
}

void TestToolController::anEmptyStrokeSaysWhy()
{
    Hand hand;
    QSignalSpy remarks(&hand.state, &EditorState::statusMessage);
    hand.state.setTool(ToolId::BrushDelete);
    hand.drag(kCenter, kCenter + QPointF(20.0, 0.0));
    QCOMPARE(remarks.count(), 1);
    QCOMPARE(remarks.last().front().toString(),
             model::reasonText(model::StrokeReason::NobodyUnderBrush));
    QCOMPARE(hand.document.undoStack().count(), 0);
}

void TestToolController::aRectangleFollowsThePointerFrameByFrame()
{
    Hand hand;
    model::BrushSettings brush = hand.state.brush(model::BrushKind::Create);
    brush.selection = model::BrushSelection::Rectangle;
    hand.state.setBrush(brush);
    hand.press({200.0, 150.0});
    hand.hover({440.0, 330.0});
    const std::size_t large = hand.document.scene().population.size();
    QVERIFY(large > 10);
    hand.hover({300.0, 240.0});
    const std::size_t small = hand.document.scene().population.size();
    QVERIFY(small < large);
    // The last bit of the way counts though no frame was drawn there.
    hand.release({440.0, 330.0});
    QCOMPARE(hand.document.scene().population.size(), large);
    QCOMPARE(hand.document.undoStack().count(), 1);
}

void TestToolController::theGhostGoesWhenItsTemplateDoes()
{
    Hand hand;
    hand.hover(kCenter);
    QVERIFY(!hand.tools.picture().ghosts.empty());
    auto edit = hand.document.beginEdit();
    edit->removeTemplate(1);
    edit->commit(QStringLiteral("remove"));
    QVERIFY(hand.tools.needsTick());
    hand.rest(0.05);
    QVERIFY(hand.tools.picture().ghosts.empty());
}

void TestToolController::changingTheToolTakesTheStrokeBack()
{
    Hand hand;
    hand.press(kCenter);
    QVERIFY(hand.tools.isDragging());
    hand.state.setTool(ToolId::Select);
    QVERIFY(!hand.tools.isDragging());
    QVERIFY(!hand.document.isEditOpen());
    QVERIFY(hand.document.scene().population.isEmpty());
}

void TestToolController::ghostStandsUnderTheCreationBrush()
{
    Hand hand;
    QSignalSpy previews(&hand.tools, &ToolController::scenePreviewChanged);
    hand.hover(kCenter);
    QVERIFY(!hand.tools.picture().ghosts.empty());
    QVERIFY(hand.tools.picture().ghosts.front().asset != nullptr);
    QVERIFY(previews.count() >= 1);
    hand.tools.leave();
    QVERIFY(hand.tools.picture().ghosts.empty());
    hand.state.setTool(ToolId::BrushColour);
    hand.hover(kCenter);
    QVERIFY(hand.tools.picture().ghosts.empty());
    QVERIFY(hand.tools.picture().circle.has_value());
}

void TestToolController::paperMappingGivesEachButtonItsSelection_data()
{
    QTest::addColumn<int>("button");
    QTest::addColumn<int>("selection");
    QTest::newRow("left paints a point")
        << static_cast<int>(Qt::LeftButton) << static_cast<int>(model::BrushSelection::Point);
    QTest::newRow("middle paints a circle")
        << static_cast<int>(Qt::MiddleButton) << static_cast<int>(model::BrushSelection::Spray);
    QTest::newRow("right paints a rectangle")
        << static_cast<int>(Qt::RightButton) << static_cast<int>(model::BrushSelection::Rectangle);
}

void TestToolController::paperMappingGivesEachButtonItsSelection()
{
    QFETCH(int, button);
    QFETCH(int, selection);
    const auto pressed = static_cast<Qt::MouseButton>(button);
    Hand hand;
    ViewOptions options = hand.state.viewOptions();
    options.buttons = ButtonMapping::Paper;
    hand.state.setViewOptions(options);
    const model::BrushSettings settings = settingsForButton(
        hand.state.brush(model::BrushKind::Create), pressed, ButtonMapping::Paper);
    QCOMPARE(static_cast<int>(settings.selection), selection);
    hand.press(kCenter, pressed);
    hand.move(kCenter + QPointF(60.0, 40.0));
    QVERIFY(hand.tools.isDragging());
    QCOMPARE(hand.tools.picture().rectangle.has_value(), pressed == Qt::RightButton);
    hand.release(kCenter + QPointF(60.0, 40.0), pressed);
    QCOMPARE(hand.document.undoStack().count(), 1);
}

void TestToolController::rightButtonAsksForThePalette()
{
    Hand hand;
    QSignalSpy requests(&hand.tools, &ToolController::paletteRequested);
    hand.press(kCenter, Qt::RightButton);
    hand.release(kCenter, Qt::RightButton);
    QCOMPARE(requests.count(), 1);
    QCOMPARE(requests.front().front().toPointF(), kCenter);
    QCOMPARE(hand.document.undoStack().count(), 0);
}

void TestToolController::keysChangeSizeAndMainNumber()
{
    Hand hand;
    hand.state.setTool(ToolId::BrushColour);
    const auto brush = [&] { return hand.state.brush(model::BrushKind::Colour); };
    const model::BrushSettings before = brush();
    QVERIFY(hand.key(Qt::Key_BracketRight));
    QVERIFY(brush().radiusPixels > before.radiusPixels);
    QVERIFY(hand.key(Qt::Key_BracketLeft));
    QVERIFY(hand.key(Qt::Key_BracketLeft));
    QVERIFY(brush().radiusPixels < before.radiusPixels);
    QVERIFY(hand.key(Qt::Key_Minus));
    QVERIFY(brush().mainNumber().value < before.mainNumber().value);
    QVERIFY(hand.key(Qt::Key_Plus, Qt::KeypadModifier));
    QCOMPARE(brush().mainNumber().value, before.mainNumber().value);
    for (int i = 0; i < 200; ++i) {
        hand.key(Qt::Key_BracketLeft);
    }
    QCOMPARE(brush().radiusPixels, model::kMinRadiusPixels);
    hand.key(Qt::Key_BracketRight);
    QVERIFY(brush().radiusPixels > model::kMinRadiusPixels);
}

void TestToolController::wheelWithControlResizes()
{
    Hand hand;
    const model::Camera before = hand.state.camera();
    const float radius = hand.state.brush(model::BrushKind::Create).radiusPixels;
    hand.modifiers = Qt::ControlModifier;
    hand.tools.wheel({hand.at(kCenter), 2.0});
    QVERIFY(hand.state.brush(model::BrushKind::Create).radiusPixels > radius);
    QVERIFY(hand.state.cameraTarget() == before);
}

void TestToolController::shiftDragResizesAndEscapeRestores()
{
    Hand hand;
    const float radius = hand.state.brush(model::BrushKind::Create).radiusPixels;
    hand.modifiers = Qt::ShiftModifier;
    hand.press(kCenter);
    hand.move(kCenter + QPointF(30.0, 0.0));
    QCOMPARE(hand.state.brush(model::BrushKind::Create).radiusPixels, radius + 30.0F);
    QCOMPARE(hand.tools.picture().circle->center, kCenter);
    hand.key(Qt::Key_Escape);
    QCOMPARE(hand.state.brush(model::BrushKind::Create).radiusPixels, radius);
    hand.drag(kCenter, kCenter + QPointF(30.0, 0.0));
    QCOMPARE(hand.state.brush(model::BrushKind::Create).radiusPixels, radius + 30.0F);
    QVERIFY(hand.document.scene().population.isEmpty());
}

void TestToolController::middleAndAltNavigateWithAnyTool_data()
{
    QTest::addColumn<int>("tool");
    for (const ToolInfo& info : toolTable()) {
        QTest::newRow(info.stableId) << static_cast<int>(info.id);
    }
}

void TestToolController::middleAndAltNavigateWithAnyTool()
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

void TestToolController::escapeGoesBackToTheViewBefore()
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

void TestToolController::spaceTappedPlaysAndHeldNavigates()
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

void TestToolController::spaceWithAModifierIsTheWindows()
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

void TestToolController::orbitStaysAboveTheGround()
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

void TestToolController::wheelGoesTowardsThePointUnderTheCursor()
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
    QVERIFY(!hand.state.isCameraMoving());
    QVERIFY(glm::length(hand.state.camera().position - point) < before * 0.75F);
    const QPointF after = hand.pixelOf(point);
    QVERIFY((after - at).manhattanLength() < 1.0);
}

void TestToolController::flyingNeedsItsModeForKeys()
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

void TestToolController::keysDoNothingElseInTheMiddleOfADrag()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 3);
    hand.state.selection().set(ids);
    hand.press(kCenter);
    QVERIFY(hand.tools.claimsKey(Qt::Key_Delete, Qt::NoModifier));
    hand.key(Qt::Key_Delete);
    hand.key(Qt::Key_Z, Qt::ControlModifier);
    hand.key(Qt::Key_V);
    QVERIFY(hand.tools.isDragging());
    QVERIFY(hand.document.scene().population.size() >= 3);
    hand.release(kCenter);
    QVERIFY(!hand.tools.claimsKey(Qt::Key_Delete, Qt::NoModifier));
}

void TestToolController::lateEventsNeverTurnTimeBack()
{
    Hand hand;
    hand.press(kCenter);
    hand.rest(0.5);
    ToolInput late = hand.at(kCenter + QPointF(5.0, 0.0));
    late.pointer.timeSeconds -= 0.4;
    hand.tools.move(late);
    hand.release(kCenter);
    QVERIFY(!hand.document.isEditOpen());
    QCOMPARE(hand.document.undoStack().count(), 1);
}

void TestToolController::bookmarksComeBack()
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

CROWD_TEST(TestToolController)
#include "tst_ToolController.moc"
