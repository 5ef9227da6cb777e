// SPDX-License-Identifier: MIT
#include "widgets/tools/ToolController.h"

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include "model/document/PathEdits.h"
#include "tests/program/Test.h"
#include "tests/widgets/Hand.h"
#include "widgets/state/BrushTexts.h"
#include "widgets/tools/PlaceHandles.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Hand;
using crowd::testing::kCenter;

class TestToolController : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void changingTheToolTakesTheStrokeBack();
    void rightButtonAsksForThePalette();
    void keysDoNothingElseInTheMiddleOfADrag();
    void lateEventsNeverTurnTimeBack();
    void theEnvironmentBrushSaysWhatItPaintsAndChoosesIt();
    void aDoubleClickPutsAPlaceIntoAPath();
    void aDoubleClickWhereCirclesTouchDoesToo();
    void aDoubleClickOfThePathBrushDoesToo();
    void aDoubleClickEndsAPath();
    void aPathOfOnePlaceGoesWhenItEnds();
    void shortStrokesInARowAreUndoneTogether();
    void whyNothingCameIsSaidAtTheCursor();
    void aPathOfPlacesIsOfTheKindThatWasAskedFor();
    void theWalkBrushComesBackToItsPath();
};

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

void TestToolController::theEnvironmentBrushSaysWhatItPaintsAndChoosesIt()
{
    Hand hand;
    hand.state.setTool(ToolId::BrushEnvironment);
    model::BrushSettings brush = hand.state.brush(model::BrushKind::Environment);
    brush.as<crowd::model::EnvironmentSettings>().role = model::PlaceRole::Forbidden;
    hand.state.setBrush(brush);
    hand.press(kCenter);
    hand.release(kCenter);
    QCOMPARE(hand.document.scene().places.size(), std::size_t{1});
    const model::Place& place = hand.document.scene().places[0];
    const QString words = placeRoleName(model::PlaceRole::Forbidden);
    QVERIFY(QString::fromStdString(place.name).startsWith(words));
    QVERIFY(hand.document.undoStack().undoText().endsWith(words));
    QCOMPARE(hand.state.paths().places(), std::vector<model::PlaceId>{place.id});
    // Then a path is begun: it is what is chosen.
    hand.state.setTool(ToolId::BrushPath);
    hand.press(kCenter + QPointF(90.0, 40.0));
    hand.release(kCenter + QPointF(90.0, 40.0));
    QVERIFY(hand.state.paths().places().empty());
    QCOMPARE(hand.state.paths().path(), hand.document.scene().paths[0].id);
    // The first obstacle is Obstacle 1, whatever else there is.
    hand.state.setTool(ToolId::BrushEnvironment);
    brush.as<crowd::model::EnvironmentSettings>().role = model::PlaceRole::Obstacle;
    hand.state.setBrush(brush);
    for (const QString& number : {QStringLiteral(" 1"), QStringLiteral(" 2")}) {
        hand.press(kCenter);
        hand.release(kCenter);
        const std::string& name = hand.document.scene().places.back().name;
        QCOMPARE(QString::fromStdString(name), placeRoleName(model::PlaceRole::Obstacle) + number);
    }
}

void TestToolController::aDoubleClickPutsAPlaceIntoAPath()
{
    Hand hand;
    hand.state.setTool(ToolId::BrushPath);
    const QPointF left = kCenter - QPointF(120.0, 0.0);
    const QPointF right = kCenter + QPointF(120.0, 0.0);
    for (const QPointF& at : {left, right}) {
        hand.press(at);
        hand.release(at);
    }
    QCOMPARE(hand.document.scene().places.size(), std::size_t{2});
    hand.key(Qt::Key_Escape);
    hand.state.setTool(ToolId::Select);
    hand.press(kCenter);
    hand.release(kCenter);
    QCOMPARE(hand.state.paths().path(), hand.document.scene().paths[0].id);
    QCOMPARE(hand.document.scene().places.size(), std::size_t{2}); // one click alone does not
    hand.clickAgain(kCenter);
    const model::Path& path = hand.document.scene().paths[0];
    QCOMPARE(path.places.size(), std::size_t{3});
    const model::Place& middle = *hand.document.scene().findPlace(path.places[1]);
    QVERIFY(QLineF(hand.pixelOf(middle.position), kCenter).length() < 2.0);
    QCOMPARE(hand.state.paths().places(), std::vector<model::PlaceId>{middle.id});
    hand.document.undoStack().undo();
    QCOMPARE(hand.document.scene().paths[0].places.size(), std::size_t{2});
    // Beside it there is no path.
    hand.clickAgain(kCenter + QPointF(0.0, 150.0));
    QCOMPARE(hand.document.scene().places.size(), std::size_t{2});
}

void TestToolController::aDoubleClickWhereCirclesTouchDoesToo()
{
    Hand hand;
    hand.state.setTool(ToolId::BrushPath);
    for (const double x : {-120.0, 120.0}) {
        hand.press(kCenter + QPointF(x, 0.0));
        hand.release(kCenter + QPointF(x, 0.0));
    }
    hand.document.edit(QStringLiteral("Wide"), [](model::SceneEdit& edit) {
        std::vector<model::Place> places = edit.scene().places;
        const float apart = glm::distance(places[0].position, places[1].position);
        for (model::Place& place : places) {
            place.radius = 0.5F * apart;
            edit.changePlace(place);
        }
    });
    hand.key(Qt::Key_Escape);
    hand.state.setTool(ToolId::Select);
    hand.press(kCenter);
    hand.release(kCenter);
    hand.clickAgain(kCenter);
    QCOMPARE(hand.document.scene().paths[0].places.size(), std::size_t{3});
}

/// Its first click begins no path that stays, nor one for people to walk along.
void TestToolController::aDoubleClickOfThePathBrushDoesToo()
{
    Hand hand;
    hand.state.setTool(ToolId::BrushPath);
    for (const double x : {-120.0, 120.0}) {
        hand.press(kCenter + QPointF(x, 0.0));
        hand.release(kCenter + QPointF(x, 0.0));
    }
    const model::PathId made = hand.document.scene().paths[0].id;
    const auto followed = [&hand] {
        return hand.state.brush(model::BrushKind::Walk).as<crowd::model::WalkSettings>().path;
    };
    QCOMPARE(followed(), made);
    hand.key(Qt::Key_Escape);
    hand.press(kCenter);
    hand.release(kCenter);
    QCOMPARE(hand.document.scene().paths.size(), std::size_t{2});
    QCOMPARE(followed(), made); // the other one leads nowhere yet
    const int steps = hand.document.undoStack().count();
    hand.clickAgain(kCenter);
    QCOMPARE(hand.document.scene().paths.size(), std::size_t{1});
    QCOMPARE(hand.document.scene().paths[0].places.size(), std::size_t{3});
    QCOMPARE(hand.document.undoStack().count(), steps); // in place of the path that was begun
    // In the open it is two places, as two clicks are.
    hand.key(Qt::Key_Escape);
    const QPointF aside = kCenter + QPointF(0.0, 150.0);
    hand.press(aside);
    hand.release(aside);
    hand.clickAgain(aside + QPointF(60.0, 0.0));
    QCOMPARE(hand.document.scene().paths.size(), std::size_t{2});
    QCOMPARE(hand.document.scene().paths[1].places.size(), std::size_t{2});
}

/// As of lines and areas.
void TestToolController::aDoubleClickEndsAPath()
{
    Hand hand;
    hand.state.setTool(ToolId::BrushPath);
    const auto clickTwice = [&hand](const QPointF& at) {
        hand.click(at);
        hand.clickAgain(at);
    };
    clickTwice(kCenter - QPointF(120.0, 0.0));
    QVERIFY(hand.state.paths().isPainting()); // one place is no path yet
    clickTwice(kCenter + QPointF(120.0, 0.0));
    QVERIFY(!hand.state.paths().isPainting());
    QCOMPARE(hand.document.scene().paths.size(), std::size_t{1});
    QCOMPARE(hand.document.scene().paths[0].places.size(), std::size_t{2});
    hand.press(kCenter + QPointF(0.0, 150.0));
    QCOMPARE(hand.document.scene().paths.size(), std::size_t{2});
}

/// By choice; what came after a pause, or by another brush, stays.
void TestToolController::shortStrokesInARowAreUndoneTogether()
{
    Hand hand;
    hand.document.replaceScene(model::Scene(), {});
    hand.state.setTool(ToolId::BrushEnvironment);
    const auto dab = [&hand](double x, double pause) {
        hand.letTimePass(pause);
        hand.press(kCenter + QPointF(x, 60.0));
        hand.release(kCenter + QPointF(x, 60.0));
    };
    const auto places = [&hand] { return hand.document.scene().places.size(); };
    const auto paint = [&] {
        dab(-120.0, 5.0);
        dab(-80.0, 5.0);
        dab(-40.0, 0.5);
        dab(0.0, 0.5);
    };
    paint();
    QCOMPARE(places(), std::size_t{4});
    hand.key(Qt::Key_Z, Qt::ControlModifier); // each by itself, unless it is chosen
    QCOMPARE(places(), std::size_t{3});
    hand.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    hand.state.undoGroups().setOn(true);
    const auto groupAt = [&hand](int step) { return hand.state.undoGroups().groupAt(step); };
    QVERIFY(groupAt(1) != 0 && groupAt(1) == groupAt(2) && groupAt(2) == groupAt(3));
    QVERIFY(groupAt(0) != groupAt(1));
    hand.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(places(), std::size_t{1});
    hand.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(places(), std::size_t{4});
    hand.key(Qt::Key_Z, Qt::ControlModifier);
    hand.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(places(), std::size_t{0});
    // What takes longer stands alone.
    paint();
    hand.letTimePass(0.2);
    hand.press(kCenter + QPointF(60.0, 60.0));
    hand.letTimePass(2.0);
    hand.release(kCenter + QPointF(60.0, 60.0));
    dab(100.0, 0.3);
    QCOMPARE(places(), std::size_t{6});
    hand.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(places(), std::size_t{5});
    hand.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(places(), std::size_t{4});
}

/// Where the hand looks, and not for ever.
void TestToolController::whyNothingCameIsSaidAtTheCursor()
{
    Hand hand;
    hand.state.setTool(ToolId::BrushColour);
    const QPointF sky(30.0, 5.0);
    hand.press(sky);
    hand.release(sky);
    QCOMPARE(hand.tools.picture().label, QStringLiteral("Nobody under the brush"));
    hand.press(sky);
    QVERIFY(hand.tools.picture().label != QStringLiteral("Nobody under the brush"));
    hand.release(sky);
    QCOMPARE(hand.tools.picture().label, QStringLiteral("Nobody under the brush"));
    QTRY_COMPARE(hand.tools.picture().label, QString());
}

/// It would lead nowhere.
void TestToolController::aPathOfOnePlaceGoesWhenItEnds()
{
    for (const Qt::Key key : {Qt::Key_Escape, Qt::Key_Return}) {
        Hand hand;
        hand.state.setTool(ToolId::BrushPath);
        hand.press(kCenter);
        hand.release(kCenter);
        QCOMPARE(hand.document.scene().paths.size(), std::size_t{1});
        hand.key(key);
        QVERIFY(hand.document.scene().paths.empty() && hand.document.scene().places.empty());
        QVERIFY(!hand.state.paths().isPainting());
        hand.document.undoStack().undo(); // it can be had back
        QCOMPARE(hand.document.scene().paths.size(), std::size_t{1});
        // One of two stays.
        hand.state.paths().paint(hand.document.scene().paths[0].id);
        hand.press(kCenter + QPointF(90.0, 40.0));
        hand.release(kCenter + QPointF(90.0, 40.0));
        hand.key(key);
        QCOMPARE(hand.document.scene().paths.size(), std::size_t{1});
        QCOMPARE(hand.document.scene().places.size(), std::size_t{2});
    }
}

void TestToolController::aPathOfPlacesIsOfTheKindThatWasAskedFor()
{
    Hand hand;
    auto edit = hand.document.beginEdit().value();
    std::vector<model::PlaceId> places;
    for (int i = 0; i < 3; ++i) {
        model::Place place;
        place.position.x = static_cast<float>(i);
        places.push_back(edit->addPlace(place));
    }
    edit->commit(QStringLiteral("Places"));
    QSignalSpy said(&hand.state, &EditorState::statusMessage);
    for (const auto kind :
         {model::PathKind::Simple, model::PathKind::Cyclic, model::PathKind::Teleport}) {
        hand.state.paths().select(places);
        makePathOfPlaces(hand.state, kind);
        QCOMPARE(hand.document.scene().paths.back().kind, kind);
        QCOMPARE(hand.document.scene().paths.back().places, places);
        QCOMPARE(hand.state.paths().path(), hand.document.scene().paths.back().id);
    }
    QCOMPARE(said.size(), 3);
    QVERIFY(said[0] != said[1] && said[1] != said[2]);
    makePathOfPlaces(hand.state, model::PathKind::Simple); // nothing is selected any more
    QCOMPARE(hand.document.scene().paths.size(), std::size_t{3});
}

void TestToolController::theWalkBrushComesBackToItsPath()
{
    Hand hand;
    const auto makePath = [&hand](float x) {
        auto edit = hand.document.beginEdit().value();
        model::Place place;
        place.position.x = x;
        const model::PathId made = model::appendPlace(*edit, 0, place, model::PathKind::Simple);
        edit->commit(QStringLiteral("A path"));
        return made;
    };
    const auto offered = [&hand] {
        return hand.state.brush(model::BrushKind::Walk).as<crowd::model::WalkSettings>().path;
    };
    const auto choose = [&hand](model::PathId path) {
        model::BrushSettings walk = hand.state.brush(model::BrushKind::Walk);
        walk.as<crowd::model::WalkSettings>().path = path;
        hand.state.setBrush(walk);
    };
    const model::PathId first = makePath(0.0F);
    QCOMPARE(offered(), first);
    const model::PathId second = makePath(3.0F);
    choose(second);
    hand.document.undoStack().undo();
    QCOMPARE(offered(), first);
    hand.document.undoStack().undo();
    QCOMPARE(offered(), model::PathId{0});
    hand.document.undoStack().redo();
    QCOMPARE(offered(), first);
    hand.document.undoStack().redo();
    QCOMPARE(offered(), second);
    // Nobody is to walk: so it stays, whatever is painted.
    choose(0);
    makePath(6.0F);
    QCOMPARE(offered(), model::PathId{0});
}

CROWD_TEST(TestToolController)
#include "tst_ToolController.moc"
