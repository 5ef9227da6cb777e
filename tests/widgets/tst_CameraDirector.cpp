// SPDX-License-Identifier: MIT
#include <QtGui/QUndoStack>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolButton>

#include "model/document/SceneEdit.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/commands/TimelineCommands.h"
#include "widgets/commands/ViewCommands.h"
#include "widgets/docks/TimelineDock.h"
#include "widgets/forms/FieldForm.h"
#include "widgets/forms/ValueSlider.h"
#include "widgets/timeline/TimelineView.h"

using namespace crowd;
using namespace crowd::widgets;

namespace {

const model::Camera kFront = model::Camera::lookingAt({0, 2, 20}, {0, 2, 0});
const model::Camera kAside = model::Camera::lookingAt({20, 2, 0}, {0, 2, 0});

struct DirectorDesk : crowd::testing::Desk<TimelineDock>
{
    DirectorDesk()
    {
        window.addDockWidget(Qt::BottomDockWidgetArea, dock);
        window.resize(900, 340);
        state.transport().setPlaying(false);
        model::Scene scene = document.scene();
        scene.cameras = {{"front", kFront}, {"aside", kAside}};
        document.replaceScene(std::move(scene), {});
    }
    [[nodiscard]] const model::Timeline& marks() { return document.scene().timeline; }
    void doubleClick(double seconds)
    {
        auto* view = dock->findChild<TimelineView*>();
        model::Mark mark;
        mark.kind = model::MarkKind::Camera;
        mark.seconds = seconds;
        QTest::mouseDClick(view, Qt::LeftButton, {}, view->placeOf(mark));
    }
    void show(double seconds) { state.transport().setSeconds(seconds); }
    [[nodiscard]] QToolButton* follow()
    {
        return dock->findChild<QToolButton*>(QStringLiteral("cameraFollow"));
    }
};

} // namespace

class TestCameraDirector : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatTheViewShowsIsPutIntoTheTimeline();
    void theViewGoesAlong();
    void whoMovesTheViewHasIt();
    void whatIsToComeIsShown();
    void whatIsWorkedUponIsSeen();
    void goingToCamerasIsRecorded();
    void renamingACameraReachesItsMarks();
    void everySceneHasItsOwn();
};

void TestCameraDirector::whatTheViewShowsIsPutIntoTheTimeline()
{
    DirectorDesk desk;
    QVERIFY(desk.isReady());
    const model::Camera free = model::Camera::lookingAt({5, 5, 5}, {0, 0, 0});
    desk.state.setCamera(free); // of no camera yet
    desk.doubleClick(3.0);
    QCOMPARE(desk.marks().size(), std::size_t{1});
    const auto& cameras = desk.document.scene().cameras;
    QCOMPARE(cameras.size(), std::size_t{3});
    QVERIFY(desk.marks()[0].kind == model::MarkKind::Camera);
    QVERIFY(cameras[2].camera == free && cameras[2].name == desk.marks()[0].camera);
    QCOMPARE(desk.state.viewCamera().name.toStdString(), cameras[2].name);
    QVERIFY(desk.state.director().isOn()); // the view has got a name, and has not moved
    desk.document.undoStack().undo();      // both in one step
    QVERIFY(desk.marks().empty() && desk.document.scene().cameras.size() == 2);
    desk.document.undoStack().redo(); // and is to be worked on
    QCOMPARE(desk.dock->findChild<TimelineView*>()->chosen(), MarkIds{desk.marks()[0].id});
    desk.document.undoStack().undo();
    desk.state.setCamera(kAside, QStringLiteral("aside"));
    desk.doubleClick(6.0);
    QVERIFY(desk.marks().size() == 1 && desk.marks()[0].camera == "aside");
    QCOMPARE(desk.document.scene().cameras.size(), std::size_t{2});
}

void TestCameraDirector::theViewGoesAlong()
{
    DirectorDesk desk;
    QVERIFY(desk.isReady());
    desk.state.setCamera(kAside, QStringLiteral("aside"));
    QVERIFY(addMark(desk.state, model::MarkKind::Camera, 2.0) != 0);
    desk.show(1.0);
    QVERIFY(desk.state.camera() == kFront); // the scene's first, until then
    desk.show(2.5);
    QVERIFY(desk.state.camera() == kAside && desk.state.viewCamera().name == u"aside");
    desk.show(0.5); // and back
    QVERIFY(desk.state.camera() == kFront);
    desk.state.transport().setPlaying(true);
    QVERIFY(QTest::qWaitFor([&] {
        desk.state.advance(0.05);
        return desk.state.camera() == kAside;
    }));
    QVERIFY(desk.state.director().isOn());
}

void TestCameraDirector::whoMovesTheViewHasIt()
{
    DirectorDesk desk;
    QVERIFY(desk.isReady());
    desk.state.setCamera(kAside, QStringLiteral("aside"));
    QVERIFY(desk.state.director().isOn() && desk.follow()->isChecked()); // nobody directs yet
    QVERIFY(addMark(desk.state, model::MarkKind::Camera, 2.0) != 0);
    desk.show(1.0);
    const QSignalSpy said(&desk.state, &EditorState::statusMessage);
    lookFrom(desk.state, ViewDirection::Top);
    desk.state.advance(1.0);
    QVERIFY(!desk.state.director().isOn() && !desk.follow()->isChecked());
    QVERIFY(said.count() == 1 && said[0][0].toString().contains(u"The view is yours"));
    const model::Camera own = desk.state.camera();
    desk.show(3.0);
    QVERIFY(desk.state.camera() == own);
    desk.state.director().setOn(true);
    desk.state.transport().setPlaying(true); // time goes on before the view does
    goToCamera(desk.state, QStringLiteral("front"));
    desk.state.advance(0.1);
    QVERIFY(!desk.state.director().isOn());
    desk.state.advance(1.0);
    QVERIFY(desk.state.camera() == kFront);
    QTest::mouseClick(desk.follow(), Qt::LeftButton);
    QVERIFY(desk.state.director().isOn() && desk.state.camera() == kAside);
}

/// Where nothing has to be played for it, all of it; else the camera alone.
void TestCameraDirector::whatIsToComeIsShown()
{
    DirectorDesk desk;
    QVERIFY(desk.isReady());
    desk.state.setCamera(kAside, QStringLiteral("aside"));
    QVERIFY(addMark(desk.state, model::MarkKind::Camera, 4.0) != 0);
    showMoment(desk.state, 5.0);
    QVERIFY(desk.state.transport().seconds() == 5.0 && desk.state.camera() == kAside);
    showMoment(desk.state, 1.0);
    QVERIFY(desk.state.camera() == kFront);
    desk.document.edit(QString(), [](model::SceneEdit& edit) {
        model::Rule rule;
        rule.id = 1;
        rule.trigger = model::triggers::Event();
        rule.actions = {model::actions::Stop()};
        edit.setRules({rule});
    });
    QVERIFY(desk.document.scene().hasBehaviour());
    const QSignalSpy said(&desk.state, &EditorState::statusMessage);
    showMoment(desk.state, 5.0);
    QVERIFY(desk.state.transport().seconds() == 1.0 && desk.state.camera() == kAside);
    QCOMPARE(said.count(), 1); // that it has not been played
    QVERIFY(desk.state.director().isOn());
}

void TestCameraDirector::whatIsWorkedUponIsSeen()
{
    DirectorDesk desk;
    QVERIFY(desk.isReady());
    desk.doubleClick(2.0);
    QCOMPARE(desk.marks()[0].camera, std::string("front"));
    desk.show(3.0);
    // What lasts is taken hold of anywhere, and something else can begin meanwhile.
    model::Timeline longer = desk.marks();
    longer[0].travel = 4.0F;
    desk.document.edit(QString(), [&longer](model::SceneEdit& edit) {
        edit.set<model::members::Timeline>(longer);
    });
    auto* view = desk.dock->findChild<TimelineView*>();
    view->choose({});
    model::Mark within = longer[0];
    within.seconds = 5.0;
    QTest::mouseClick(view, Qt::LeftButton, {}, view->placeOf(within));
    QCOMPARE(view->chosen(), MarkIds{longer[0].id});
    desk.doubleClick(5.0);
    QCOMPARE(desk.marks().size(), std::size_t{2});
    desk.document.undoStack().undo();
    desk.document.undoStack().undo();
    view->choose({longer[0].id});
    auto* form = desk.dock->findChild<FieldForm*>(QStringLiteral("markForm"));
    QVERIFY(form != nullptr && form->isVisible());
    QComboBox* cameras = nullptr;
    for (QComboBox* each : form->findChildren<QComboBox*>()) {
        cameras = each->findText(QStringLiteral("aside")) >= 0 ? each : cameras;
    }
    QVERIFY(cameras != nullptr && cameras->isVisible());
    QCOMPARE(cameras->count(), 3); // or from where it is
    cameras->setCurrentIndex(2);
    Q_EMIT cameras->activated(2);
    QCOMPARE(desk.marks()[0].camera, std::string("aside"));
    QVERIFY(desk.state.camera() == kAside);
    ValueSlider* at = nullptr;
    for (ValueSlider* each : form->findChildren<ValueSlider*>()) {
        at = each->isVisible() && at == nullptr ? each : at;
    }
    QVERIFY(at != nullptr);
    QTest::keyClick(at, Qt::Key_Return); // more than the bar has
    QTest::keyClicks(at->findChild<QLineEdit*>(), QStringLiteral("150"));
    QTest::keyClick(at->findChild<QLineEdit*>(), Qt::Key_Return);
    QCOMPARE(desk.marks()[0].seconds, 150.0);
    desk.document.undoStack().undo();
    removeCamera(desk.state, QStringLiteral("aside"));
    QVERIFY(desk.state.camera() == kFront); // it stays where it is, and says so
}

void TestCameraDirector::goingToCamerasIsRecorded()
{
    DirectorDesk desk;
    QVERIFY(desk.isReady());
    desk.state.session().recorder().setOn(true);
    goToCamera(desk.state, QStringLiteral("aside")); // nothing plays: not a part of the show
    desk.show(1.5);
    desk.state.transport().setPlaying(true);
    goToCamera(desk.state, QStringLiteral("front"));
    desk.state.advance(0.5);
    goToCamera(desk.state, QStringLiteral("aside"));
    desk.state.advance(0.5);
    QVERIFY(desk.state.camera() == kAside);
    QTRY_COMPARE(desk.marks().size(), std::size_t{2});
    QVERIFY(desk.marks()[0].camera == "front" && desk.marks()[0].seconds == 1.5);
    QVERIFY(desk.marks()[1].camera == "aside" && desk.marks()[1].seconds == 2.0);
    goToCamera(desk.state, QStringLiteral("front"));
    desk.state.advance(0.5);
    QTRY_COMPARE(desk.marks().size(), std::size_t{3});
    QVERIFY(!desk.state.director().isOn() && desk.state.camera() == kFront);
    desk.state.session().recorder().setOn(false); // it is on the screen what was recorded
    QVERIFY(desk.state.director().isOn());
}

void TestCameraDirector::renamingACameraReachesItsMarks()
{
    DirectorDesk desk;
    QVERIFY(desk.isReady());
    QVERIFY(addMark(desk.state, model::MarkKind::Camera, 2.0) != 0);
    QVERIFY(renameCamera(desk.state, QStringLiteral("front"), QStringLiteral("Stalls")));
    QCOMPARE(desk.marks()[0].camera, std::string("Stalls"));
    desk.document.undoStack().undo();
    QCOMPARE(desk.marks()[0].camera, std::string("front"));
}

void TestCameraDirector::everySceneHasItsOwn()
{
    DirectorDesk desk;
    QVERIFY(desk.isReady());
    desk.state.setCamera(kAside, QStringLiteral("aside"));
    QVERIFY(addMark(desk.state, model::MarkKind::Camera, 0.0) != 0);
    desk.show(1.0);
    lookFrom(desk.state, ViewDirection::Top);
    desk.state.advance(1.0);
    QVERIFY(!desk.state.director().isOn());
    model::Scene scene = desk.document.scene();
    const QSignalSpy said(&desk.state, &EditorState::statusMessage);
    desk.document.replaceScene(scene, {});
    QVERIFY(desk.state.director().isOn());
    QVERIFY(desk.state.camera() == kAside); // as its timeline has it from the beginning
    scene.timeline.clear();
    desk.document.replaceScene(scene, {});
    QVERIFY(desk.state.camera() == kFront && desk.state.director().isOn());
    QCOMPARE(said.count(), 0);
}

CROWD_WINDOW_TEST(TestCameraDirector)
#include "tst_CameraDirector.moc"
