// SPDX-License-Identifier: MIT
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include "tests/program/Test.h"
#include "tests/widgets/Hand.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Hand;

class TestSelectTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void clickSelectsAndEmptyGroundClears();
    void clickOnABandChoosesItsPath();
    void modifiersAddAndToggle();
    void rectangleSelectsWhatIsInside();
    void aLassoSelectsWhatItGoesRound();
    void withShiftARectangleBeginsOnSomebodyToo();
    void escapeKeepsTheSelectionOfBefore();
    void selectionForgetsWhoVanishes();
    void whoIsBackIsSelectedAgain();
    void deleteRemovesTheSelectedInOneStep();
    void draggingSomebodyMovesThemInOneStep();
};

void TestSelectTool::clickSelectsAndEmptyGroundClears()
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

void TestSelectTool::clickOnABandChoosesItsPath()
{
    Hand hand;
    auto edit = hand.document.beginEdit().value();
    model::Path path;
    path.name = "Path";
    for (const float x : {-6.0F, 6.0F}) {
        model::Place place;
        place.position = {x, 0.05F, 8.0F};
        place.radius = 1.5F;
        path.places.push_back(edit->addPlace(place));
    }
    const model::PathId id = edit->addPath(path);
    edit->commit(QStringLiteral("path"));
    hand.state.setTool(ToolId::Select);
    const model::View view(hand.state.camera(), hand.state.viewSize());
    const auto click = [&](const glm::vec3& point) {
        const glm::vec3 pixel = view.project(point).value();
        hand.drag({pixel.x, pixel.y}, {pixel.x, pixel.y});
    };
    click({1.0F, 0.05F, 8.8F}); // off the middle, on the band
    QCOMPARE(hand.state.paths().path(), id);
    click({1.0F, 0.05F, 5.0F});
    QCOMPARE(hand.state.paths().path(), model::PathId{0});
    QCOMPARE(hand.document.undoStack().count(), 1);
}

void TestSelectTool::modifiersAddAndToggle()
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

void TestSelectTool::rectangleSelectsWhatIsInside()
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

void TestSelectTool::aLassoSelectsWhatItGoesRound()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 6);
    hand.state.setTool(ToolId::Select);
    ViewOptions options = hand.state.viewOptions();
    options.selectsByLasso = true;
    hand.state.setViewOptions(options);
    // Down before the second, under the third, up behind it, and back to where it began.
    const QPointF from = hand.pixelOf(ids[1]) + QPointF(-14.0, -120.0);
    const QPointF to = hand.pixelOf(ids[2]) + QPointF(14.0, -120.0);
    hand.press(from);
    for (const QPointF& corner : {from + QPointF(0.0, 230.0), to + QPointF(0.0, 230.0), to}) {
        hand.move(corner);
    }
    QVERIFY(!hand.tools.picture().rectangle.has_value());
    QCOMPARE(hand.tools.picture().outlines.size(), std::size_t{1});
    hand.release(from);
    const auto selected = hand.state.selection().ids();
    QCOMPARE(std::vector<model::IndividualId>(selected.begin(), selected.end()),
             (std::vector<model::IndividualId>{ids[1], ids[2]}));
    hand.drag(hand.pixelOf(ids[4]), hand.pixelOf(ids[4]));
    QVERIFY2(hand.state.selection().contains(ids[4]), "a click still selects");
}

void TestSelectTool::withShiftARectangleBeginsOnSomebodyToo()
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
    QVERIFY2(hand.document.undoStack().count() == steps, "only who is selected can be dragged");
    QVERIFY(!hand.state.selection().contains(ids[0]));
}

void TestSelectTool::escapeKeepsTheSelectionOfBefore()
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

void TestSelectTool::selectionForgetsWhoVanishes()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 3);
    hand.state.selection().set(ids);
    QSignalSpy changes(&hand.state.selection(), &Selection::changed);
    auto edit = hand.document.beginEdit().value();
    edit->removeIndividuals(std::vector{ids[0], ids[2]});
    edit->commit(QStringLiteral("remove"));
    QCOMPARE(hand.state.selection().size(), std::size_t{1});
    QVERIFY(changes.count() >= 1);
    hand.state.selection().apply(std::vector{ids[0]}, SelectionMode::Add);
    QCOMPARE(hand.state.selection().size(), std::size_t{1});
    hand.document.replaceScene(testing::smallTheatre(), {});
    QVERIFY(hand.state.selection().isEmpty());
}

void TestSelectTool::whoIsBackIsSelectedAgain()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 5);
    const std::vector<model::IndividualId> two{ids[0], ids[3]};
    const auto selected = [&hand] {
        const auto now = hand.state.selection().ids();
        return std::vector<model::IndividualId>(now.begin(), now.end());
    };
    hand.state.selection().set(two);
    QVERIFY(hand.key(Qt::Key_Delete));
    QVERIFY(selected().empty());
    hand.document.undoStack().undo();
    QCOMPARE(selected(), two);
    hand.document.undoStack().redo();
    hand.document.undoStack().undo();
    QCOMPARE(selected(), two);
    // Who has chosen somebody else since then means him.
    hand.document.undoStack().redo();
    hand.state.selection().set(std::vector{ids[1]});
    hand.document.undoStack().undo();
    QCOMPARE(selected(), (std::vector<model::IndividualId>{ids[1]}));
    // A new one who has the id of one whose creation was undone is somebody else.
    hand.state.selection().set(std::vector{ids[4]});
    hand.document.undoStack().undo();
    QVERIFY(selected().empty());
    QCOMPARE(testing::addPeople(hand.document, 5).back(), ids[4]);
    QVERIFY(selected().empty());
}

void TestSelectTool::deleteRemovesTheSelectedInOneStep()
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

void TestSelectTool::draggingSomebodyMovesThemInOneStep()
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
    hand.drag(from, from);
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

CROWD_TEST(TestSelectTool)
#include "tst_SelectTool.moc"
