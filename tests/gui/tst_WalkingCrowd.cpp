// SPDX-License-Identifier: MIT
#include <string>

#include <QtTest/QTest>

#include "model/rules/RuleSets.h"
#include "tests/gui/Studio.h"
#include "tests/program/WindowTest.h"
#include "widgets/state/Cues.h"
#include "widgets/tools/BrushTool.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Studio;

namespace {

/// Empty ground seen from above, with somebody to paint with.
model::Scene ground()
{
    model::Scene scene = testing::smallTheatre();
    scene.stages.clear();
    scene.cameras = {{"above", model::Camera::lookingAt({0.0F, 22.0F, 12.0F}, {0.0F, 0.0F, 0.0F})}};
    return scene;
}

void click(Studio& studio, QPoint at)
{
    studio.send(QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton);
    studio.drag(at, at);
}

void key(Studio& studio, Qt::Key which)
{
    QTest::keyClick(studio.view, which);
}

/// A triangle of places, painted with the mouse and ended with Enter.
void paintPath(Studio& studio)
{
    key(studio, Qt::Key_P);
    for (const QPoint at : {QPoint(80, 80), QPoint(240, 80), QPoint(240, 180)}) {
        click(studio, at);
    }
    key(studio, Qt::Key_Return);
}

void paintPeople(Studio& studio)
{
    key(studio, Qt::Key_C);
    model::BrushSettings brush = studio.state.brush(model::BrushKind::Create);
    brush.selection = model::BrushSelection::AllInCircle;
    brush.radiusPixels = 30.0F;
    brush.as<crowd::model::CreateSettings>().density = 0.5F;
    studio.state.setBrush(brush);
    studio.drag({80, 150}, {120, 160});
}

void paintWalk(Studio& studio)
{
    key(studio, Qt::Key_W);
    model::BrushSettings brush = studio.state.brush(model::BrushKind::Walk);
    brush.selection = model::BrushSelection::Rectangle;
    studio.state.setBrush(brush);
    studio.drag({5, 5}, {314, 234});
}

/// How far people are from where the scene has them, at most.
float farthest(Studio& studio)
{
    const auto frame = studio.state.frame();
    const auto shown = frame->population.column(model::columns::position);
    const auto scene = studio.document.scene().population.column(model::columns::position);
    float most = 0.0F;
    for (std::size_t row = 0; row < shown.size(); ++row) {
        most = std::max(most, glm::distance(shown[row], scene[row]));
    }
    return most;
}

} // namespace

class TestWalkingCrowd : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aPathIsPaintedPlaceByPlace();
    void placesAreMovedResizedAndDeleted();
    void keysResizeTheSelectedPlaces();
    void paintWalkPlayStopAndKeep();
    void brushesReachPeopleWhoWalk();
    void anEventMakesPeopleRun();
    void aCueIsHeardByItsKey();
    void aWalkingStyleIsPaintedOn();
    void paintedGroundChangesTheWay();
};

void TestWalkingCrowd::aPathIsPaintedPlaceByPlace()
{
    Studio studio(ground());
    QVERIFY(studio.isReady());
    const std::string empty = studio.bytes();
    key(studio, Qt::Key_P);
    QCOMPARE(studio.state.tool(), ToolId::BrushPath);
    const float radius = studio.state.brush(model::BrushKind::Path).place()->radiusMetres;
    click(studio, {80, 80});
    key(studio, Qt::Key_Plus);
    click(studio, {240, 80});
    const auto& scene = studio.document.scene();
    QCOMPARE(scene.paths.size(), std::size_t{1});
    QCOMPARE(scene.places.size(), std::size_t{2});
    QCOMPARE(scene.places[0].radius, radius);
    QVERIFY(scene.places[1].radius > radius);
    QVERIFY(scene.places[1].position.x > scene.places[0].position.x + 3.0F);
    QCOMPARE(studio.document.undoStack().count(), 2);
    click(studio, {240, 180});
    key(studio, Qt::Key_Return);
    click(studio, {160, 200}); // begins another path
    QCOMPARE(scene.paths.size(), std::size_t{2});
    QCOMPARE(scene.paths[0].places, (std::vector<model::PlaceId>{1, 2, 3}));
    QCOMPARE(scene.paths[0].kind, model::PathKind::Simple); // it ends where it was ended
    QCOMPARE(scene.paths[1].places, (std::vector<model::PlaceId>{4}));
    const std::string full = studio.bytes();
    const QImage painted = studio.picture();
    while (studio.document.undoStack().canUndo()) {
        studio.document.undoStack().undo();
    }
    QCOMPARE(studio.bytes(), empty);
    QVERIFY(studio.picture() != painted);
    while (studio.document.undoStack().canRedo()) {
        studio.document.undoStack().redo();
    }
    QCOMPARE(studio.bytes(), full);
}

void TestWalkingCrowd::placesAreMovedResizedAndDeleted()
{
    Studio studio(ground());
    QVERIFY(studio.isReady());
    paintPath(studio);
    key(studio, Qt::Key_V);
    const model::Place before = studio.document.scene().places[0];
    const auto pixel = studio.view->tools().queries().view().project(before.position);
    const QPoint middle(qRound(pixel->x), qRound(pixel->y));
    click(studio, middle);
    QCOMPARE(studio.state.paths().places(), std::vector<model::PlaceId>{before.id});
    QCOMPARE(studio.state.paths().path(), model::PathId{1});
    studio.drag(middle, middle + QPoint(20, 30));
    const model::Place moved = studio.document.scene().places[0];
    QVERIFY(moved.position.x > before.position.x && moved.position.z > before.position.z);
    QCOMPARE(moved.radius, before.radius);
    const auto edge = studio.view->tools().queries().view().project(
        moved.position + glm::vec3(moved.radius, 0.0F, 0.0F));
    const QPoint border(qRound(edge->x), qRound(edge->y));
    studio.drag(border, border + QPoint(25, 0));
    QVERIFY(studio.document.scene().places[0].radius > moved.radius * 1.3F);
    QCOMPARE(studio.document.scene().places[0].position, moved.position);
    const int steps = studio.document.undoStack().count();
    key(studio, Qt::Key_Delete);
    QCOMPARE(studio.document.scene().places.size(), std::size_t{2});
    QCOMPARE(studio.document.undoStack().count(), steps + 1);
    studio.document.undoStack().undo();
    studio.document.undoStack().undo();
    studio.document.undoStack().undo();
    QCOMPARE(studio.document.scene().places[0], before);
}

void TestWalkingCrowd::keysResizeTheSelectedPlaces()
{
    Studio studio(ground());
    QVERIFY(studio.isReady());
    paintPath(studio);
    key(studio, Qt::Key_V);
    const std::vector<model::Place> before = studio.document.scene().places;
    const int steps = studio.document.undoStack().count();
    key(studio, Qt::Key_Plus); // none is selected
    QCOMPARE(studio.document.undoStack().count(), steps);
    studio.state.paths().select({before[0].id, before[2].id});
    key(studio, Qt::Key_Plus);
    const auto& places = studio.document.scene().places;
    model::BrushSettings brush = studio.state.brush(model::BrushKind::Path);
    brush.place()->radiusMetres = before[0].radius;
    QCOMPARE(places[0].radius, steppedMainNumber(brush, 1).place()->radiusMetres);
    QCOMPARE(places[1], before[1]);
    QVERIFY(places[2].radius > before[2].radius);
    QCOMPARE(studio.document.undoStack().count(), steps + 1);
    key(studio, Qt::Key_Minus);
    key(studio, Qt::Key_Minus);
    QVERIFY(places[0].radius < before[0].radius);
    for (int i = 0; i < 3; ++i) {
        studio.document.undoStack().undo();
    }
    QCOMPARE(places, before);
    // The path brush goes on sizing the next place.
    key(studio, Qt::Key_P);
    key(studio, Qt::Key_Plus);
    QCOMPARE(places, before);
    QVERIFY(studio.state.brush(model::BrushKind::Path) != brush);
}

void TestWalkingCrowd::paintWalkPlayStopAndKeep()
{
    Studio studio(ground());
    QVERIFY(studio.isReady());
    paintPath(studio);
    paintPeople(studio);
    QVERIFY(studio.people() > 3);
    paintWalk(studio);
    const auto followed = studio.document.scene().population.column(model::columns::path);
    QVERIFY(std::all_of(followed.begin(), followed.end(), [](auto path) { return path == 1; }));
    const std::string before = studio.bytes();
    QVERIFY(!studio.state.session().isRunning());
    studio.state.transport().setPlaying(true);
    QTRY_VERIFY(studio.state.session().isRunning());
    QTRY_VERIFY_WITH_TIMEOUT(farthest(studio) > 1.5F, 20000);
    QCOMPARE(studio.bytes(), before); // the scene stays as it is
    studio.state.transport().setPlaying(false);
    const double paused = studio.state.transport().seconds();
    const glm::vec3 there = studio.state.frame()->population.column(model::columns::position)[0];
    studio.state.session().stepOnce();
    QVERIFY(studio.state.transport().seconds() > paused);
    QTRY_VERIFY(studio.state.frame()->population.column(model::columns::position)[0] != there);
    QVERIFY(studio.state.session().keepPose());
    QVERIFY(studio.bytes() != before);
    QVERIFY(farthest(studio) < 0.2F);
    studio.state.session().stop();
    QVERIFY(!studio.state.session().isRunning());
    QCOMPARE(studio.state.transport().seconds(), 0.0);
    QCOMPARE(farthest(studio), 0.0F);
    studio.document.undoStack().undo();
    QCOMPARE(studio.bytes(), before);
}

void TestWalkingCrowd::brushesReachPeopleWhoWalk()
{
    Studio studio(ground());
    QVERIFY(studio.isReady());
    paintPath(studio);
    paintPeople(studio);
    paintWalk(studio);
    studio.state.transport().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(farthest(studio) > 2.0F, 20000);
    studio.state.transport().setPlaying(false);
    // One of them is coloured where he is shown, not where the scene has him.
    const auto frame = studio.state.frame();
    const glm::vec3 shown = frame->population.column(model::columns::position)[0];
    const auto pixel =
        studio.view->tools().queries().view().project(shown + glm::vec3(0.0F, 0.8F, 0.0F));
    model::BrushSettings brush = studio.state.brush(model::BrushKind::Colour);
    brush.selection = model::BrushSelection::Point;
    brush.as<crowd::model::ColourSettings>().colors = {{9, 200, 10}};
    studio.state.setBrush(brush);
    key(studio, Qt::Key_B);
    click(studio, {qRound(pixel->x), qRound(pixel->y)});
    const auto tint = studio.document.scene().population.column(model::columns::tint(0))[0];
    QCOMPARE(int{tint.green}, 200);
    QVERIFY(studio.state.session().isRunning());
    QCOMPARE(int{studio.state.frame()->population.column(model::columns::tint(0))[0].green}, 200);
    // Whoever is deleted while it runs is gone; who is created walks too.
    const std::size_t people = studio.people();
    key(studio, Qt::Key_X);
    model::BrushSettings removal = studio.state.brush(model::BrushKind::Delete);
    removal.selection = model::BrushSelection::Point;
    studio.state.setBrush(removal);
    click(studio, {qRound(pixel->x), qRound(pixel->y)});
    QCOMPARE(studio.people(), people - 1);
    QCOMPARE(studio.state.frame()->population.size(), people - 1);
    studio.document.undoStack().undo();
    QCOMPARE(studio.people(), people);
}

void TestWalkingCrowd::anEventMakesPeopleRun()
{
    Studio studio(ground());
    QVERIFY(studio.isReady());
    paintPath(studio);
    paintPeople(studio);
    paintWalk(studio);
    auto edit = studio.document.beginEdit().value();
    std::vector<model::Rule> rules =
        model::rulesOf(model::RuleSet::Pedestrians, studio.document.scene());
    model::giveIds(rules, studio.document.scene());
    const model::RuleId run = rules.front().id;
    edit->setRules(rules);
    edit->commit(QStringLiteral("Rules"));
    key(studio, Qt::Key_E);
    model::BrushSettings brush = studio.state.brush(model::BrushKind::Event);
    brush.selection = model::BrushSelection::Rectangle;
    brush.as<crowd::model::EventSettings>() = {"run", 2.0F};
    studio.state.setBrush(brush);
    const int steps = studio.document.undoStack().count();
    studio.drag({5, 5}, {314, 234});
    QCOMPARE(studio.state.session().firedCount(run), std::uint64_t{0}); // nothing runs yet
    studio.state.transport().setPlaying(true);
    QTRY_VERIFY(studio.state.session().isRunning());
    key(studio, Qt::Key_Plus);
    studio.drag({5, 5}, {314, 234});
    QTRY_COMPARE(studio.state.session().firedCount(run),
                 static_cast<std::uint64_t>(studio.people()));
    QCOMPARE(studio.document.undoStack().count(), steps);
}

void TestWalkingCrowd::aCueIsHeardByItsKey()
{
    Studio studio(ground());
    QVERIFY(studio.isReady());
    const CueKeys keys(studio.state, studio.view->window());
    paintPath(studio);
    paintPeople(studio);
    paintWalk(studio);
    auto edit = studio.document.beginEdit().value();
    std::vector<model::Rule> rules =
        model::rulesOf(model::RuleSet::Pedestrians, studio.document.scene());
    model::giveIds(rules, studio.document.scene());
    const model::RuleId run = rules.front().id;
    edit->setRules(rules);
    edit->setCues({{1, "Run", "run", 2.5F, "F3", model::CueReach::Everybody, 0}});
    edit->commit(QStringLiteral("Rules"));
    key(studio, Qt::Key_F3);
    QCOMPARE(studio.state.session().firedCount(run), std::uint64_t{0}); // nothing runs yet
    studio.state.transport().setPlaying(true);
    QTRY_VERIFY(studio.state.session().isRunning());
    key(studio, Qt::Key_F3);
    QTRY_COMPARE(studio.state.session().firedCount(run),
                 static_cast<std::uint64_t>(studio.people()));
    // Another key, and the old one is silent.
    edit = studio.document.beginEdit().value();
    edit->setCues({{1, "Run", "run", 2.5F, "F7", model::CueReach::Selected, 0}});
    edit->commit(QStringLiteral("Cue"));
    studio.state.selection().set(studio.document.scene().population.ids().first(1));
    key(studio, Qt::Key_F3);
    key(studio, Qt::Key_F7);
    QTRY_COMPARE(studio.state.session().firedCount(run),
                 static_cast<std::uint64_t>(studio.people()) + 1);
}

void TestWalkingCrowd::aWalkingStyleIsPaintedOn()
{
    Studio studio(ground());
    QVERIFY(studio.isReady());
    paintPeople(studio);
    key(studio, Qt::Key_R);
    QCOMPARE(studio.state.tool(), ToolId::BrushStyle);
    model::BrushSettings brush = studio.state.brush(model::BrushKind::Style);
    brush.selection = model::BrushSelection::Rectangle;
    brush.as<crowd::model::StyleSettings>().speed = {2.0F, 2.0F};
    studio.state.setBrush(brush);
    key(studio, Qt::Key_Plus);
    const std::string before = studio.bytes();
    studio.drag({5, 5}, {314, 234});
    const auto speeds = studio.document.scene().population.column(model::columns::walkSpeed);
    for (const float speed : speeds) {
        QVERIFY2(std::abs(speed - 2.1F) < 1e-3F, QByteArray::number(static_cast<double>(speed)));
    }
    studio.document.undoStack().undo();
    QCOMPARE(studio.bytes(), before);
}

void TestWalkingCrowd::paintedGroundChangesTheWay()
{
    Studio studio(ground());
    QVERIFY(studio.isReady());
    paintPath(studio);
    paintPeople(studio);
    paintWalk(studio);
    QCOMPARE(studio.state.session().surfacePolygons(), std::size_t{0}); // open ground
    key(studio, Qt::Key_I);
    model::BrushSettings brush = studio.state.brush(model::BrushKind::Environment);
    brush.as<crowd::model::EnvironmentSettings>().role = model::PlaceRole::Forbidden;
    studio.state.setBrush(brush);
    click(studio, {160, 120});
    QTRY_VERIFY(studio.state.session().surfacePolygons() > 0);
    const std::size_t polygons = studio.state.session().surfacePolygons();
    click(studio, {110, 150});
    QTRY_VERIFY(studio.state.session().surfacePolygons() > polygons);
    while (studio.document.scene().places.size() > 3) {
        studio.document.undoStack().undo();
    }
    QTRY_COMPARE(studio.state.session().surfacePolygons(), std::size_t{0});
}

CROWD_WINDOW_TEST(TestWalkingCrowd)
#include "tst_WalkingCrowd.moc"
