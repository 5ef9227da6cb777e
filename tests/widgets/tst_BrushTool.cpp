// SPDX-License-Identifier: MIT
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include "model/brush/Stroke.h"
#include "tests/program/Test.h"
#include "tests/widgets/Hand.h"
#include "widgets/tools/BrushTool.h"
#include "widgets/tools/ScriptPainter.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Hand;
using crowd::testing::kCenter;

namespace {

/// What a script brush would be told.
class Listener : public ScriptPainter
{
public:
    [[nodiscard]] bool begin(const model::BrushContext& /*context*/,
                             const model::BrushSettings& settings, std::uint64_t /*seed*/,
                             const model::PointerInput& /*press*/) override
    {
        selection = settings.selection;
        return true;
    }
    void move(const model::PointerInput& /*input*/) override { ++moves; }
    void pass(const model::PointerInput& /*input*/) override { ++passes; }
    void release() override {}
    void cancel() override {}
    [[nodiscard]] bool isPainting() const override { return false; }
    [[nodiscard]] int affected() const override { return 3; }

    model::BrushSelection selection{};
    int moves = 0;
    int passes = 0;
};

} // namespace

class TestBrushTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aStrokeIsOneUndoStep();
    void escapeTakesTheStrokeBack();
    void aStillButtonGoesOnSpraying();
    void anEmptyStrokeSaysWhy();
    void aRectangleFollowsThePointerFrameByFrame();
    void theGhostGoesWhenItsTemplateDoes();
    void ghostStandsUnderTheCreationBrush();
    void whoWouldBeHitIsMarkedBeforeThePress();
    void newBrushesSpareSkinAndVaryFaces();
    void paperMappingGivesEachButtonItsSelection_data();
    void paperMappingGivesEachButtonItsSelection();
    void scriptBrushesShowTheirArea_data();
    void scriptBrushesShowTheirArea();
    void keysChangeSizeAndMainNumber();
    void wheelWithControlResizes();
    void shiftDragResizesAndEscapeRestores();
};

void TestBrushTool::aStrokeIsOneUndoStep()
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

void TestBrushTool::escapeTakesTheStrokeBack()
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

void TestBrushTool::aStillButtonGoesOnSpraying()
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

void TestBrushTool::anEmptyStrokeSaysWhy()
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

void TestBrushTool::aRectangleFollowsThePointerFrameByFrame()
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

void TestBrushTool::theGhostGoesWhenItsTemplateDoes()
{
    Hand hand;
    hand.hover(kCenter);
    QVERIFY(!hand.tools.picture().ghosts.empty());
    auto edit = hand.document.beginEdit().value();
    edit->removeTemplate(1);
    edit->commit(QStringLiteral("remove"));
    QVERIFY(hand.tools.needsTick());
    hand.rest(0.05);
    QVERIFY(hand.tools.picture().ghosts.empty());
}

void TestBrushTool::ghostStandsUnderTheCreationBrush()
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

void TestBrushTool::whoWouldBeHitIsMarkedBeforeThePress()
{
    Hand hand;
    hand.press(kCenter);
    hand.rest(1.0);
    hand.release(kCenter);
    const std::size_t people = hand.document.scene().population.size();
    QVERIFY(people > 3);
    const model::IndividualId first = hand.document.scene().population.ids()[0];
    hand.state.setTool(ToolId::BrushColour);
    QSignalSpy scenes(&hand.tools, &ToolController::scenePreviewChanged);
    model::BrushSettings brush = hand.state.brush(model::BrushKind::Colour);
    brush.radiusPixels = 300.0F;
    brush.through = true;
    hand.state.setBrush(brush);
    hand.hover(kCenter);
    QCOMPARE(hand.tools.picture().candidates.size(), people);
    QCOMPARE(scenes.count(), 0); // marked over the picture, which is not drawn again for it
    brush.radiusPixels = 2.0F;
    hand.state.setBrush(brush);
    hand.hover(hand.pixelOf(first));
    const auto marked = hand.tools.picture().candidates;
    QVERIFY(!marked.empty() && marked.size() < people);
    hand.press(hand.pixelOf(first));
    QVERIFY(hand.tools.picture().candidates.empty());
    hand.release(hand.pixelOf(first));
    hand.hover({5.0, 5.0});
    QVERIFY(hand.tools.picture().candidates.empty());
    hand.hover(hand.pixelOf(first));
    hand.state.setTool(ToolId::Select);
    hand.hover(hand.pixelOf(first));
    QVERIFY(hand.tools.picture().candidates.empty());
}

void TestBrushTool::newBrushesSpareSkinAndVaryFaces()
{
    Hand hand;
    QVERIFY(
        hand.state.brush(model::BrushKind::Colour).as<crowd::model::ColourSettings>().sparesBody);
    model::BrushSettings brush = hand.state.brush(model::BrushKind::Create);
    QCOMPARE(brush.as<crowd::model::CreateSettings>().variesFaces, std::optional<bool>(true));
}

void TestBrushTool::paperMappingGivesEachButtonItsSelection_data()
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

void TestBrushTool::paperMappingGivesEachButtonItsSelection()
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

void TestBrushTool::scriptBrushesShowTheirArea_data()
{
    QTest::addColumn<int>("selection");
    QTest::addColumn<int>("mapping");
    QTest::addColumn<int>("pressed");
    const auto row = [](const char* name, model::BrushSelection selection, ButtonMapping mapping,
                        model::BrushSelection pressed) {
        QTest::newRow(name) << static_cast<int>(selection) << static_cast<int>(mapping)
                            << static_cast<int>(pressed);
    };
    using model::BrushSelection;
    row("lasso", BrushSelection::Lasso, ButtonMapping::Standard, BrushSelection::Lasso);
    row("rectangle", BrushSelection::Rectangle, ButtonMapping::Standard, BrushSelection::Rectangle);
    row("spray", BrushSelection::Spray, ButtonMapping::Standard, BrushSelection::Spray);
    row("point of the paper", BrushSelection::Lasso, ButtonMapping::Paper, BrushSelection::Point);
}

void TestBrushTool::scriptBrushesShowTheirArea()
{
    QFETCH(int, selection);
    QFETCH(int, mapping);
    QFETCH(int, pressed);
    Hand hand;
    Listener painter;
    ScriptBrush script;
    script.settings.as<model::ScriptSettings>().brush = "Listener";
    script.settings.selection = static_cast<model::BrushSelection>(selection);
    hand.state.setScriptPainter(&painter);
    hand.state.putScriptBrush(script);
    hand.state.chooseScriptBrush("Listener");
    ViewOptions options = hand.state.viewOptions();
    options.buttons = static_cast<ButtonMapping>(mapping);
    hand.state.setViewOptions(options);
    hand.state.setTool(ToolId::BrushScript);
    hand.press(kCenter);
    QCOMPARE(static_cast<int>(painter.selection), pressed);
    for (int step = 1; step <= 20; ++step) {
        hand.move(kCenter + QPointF(step * 3.0, step % 5 * 4.0));
    }
    const auto area = static_cast<model::BrushSelection>(pressed);
    const ToolPicture& picture = hand.tools.picture();
    const bool isLasso = area == model::BrushSelection::Lasso;
    QCOMPARE(picture.outlines.size(), isLasso ? std::size_t{1} : std::size_t{0});
    if (isLasso) {
        QCOMPARE(picture.outlines.front().size(), 22);
    }
    QCOMPARE(picture.rectangle.has_value(), area == model::BrushSelection::Rectangle);
    QVERIFY(picture.label.contains(u'3'));
    const bool isWhole = isLasso || area == model::BrushSelection::Rectangle;
    QCOMPARE(painter.moves, isWhole ? 0 : 20); // an area once a picture
    QCOMPARE(painter.passes, isLasso ? 20 : 0);
    hand.hover(kCenter + QPointF(60.0, 0.0));
    QVERIFY(painter.moves > (isWhole ? 0 : 20));
    const int moves = painter.moves;
    hand.rest(0.1);
    QCOMPARE(painter.moves == moves, isWhole);
    hand.release(kCenter);
    hand.state.setScriptPainter(nullptr);
}

void TestBrushTool::keysChangeSizeAndMainNumber()
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

void TestBrushTool::wheelWithControlResizes()
{
    Hand hand;
    const model::Camera before = hand.state.camera();
    const float radius = hand.state.brush(model::BrushKind::Create).radiusPixels;
    hand.modifiers = Qt::ControlModifier;
    hand.tools.wheel({hand.at(kCenter), 2.0});
    QVERIFY(hand.state.brush(model::BrushKind::Create).radiusPixels > radius);
    QVERIFY(hand.state.cameraTarget() == before);
}

void TestBrushTool::shiftDragResizesAndEscapeRestores()
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

CROWD_TEST(TestBrushTool)
#include "tst_BrushTool.moc"
