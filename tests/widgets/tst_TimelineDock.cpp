// SPDX-License-Identifier: MIT
#include <cmath>
#include <utility>

#include <QtGui/QUndoStack>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QSplitter>
#include <QtWidgets/QToolButton>

#include "model/document/SceneEdit.h"
#include "model/rules/RuleSets.h"
#include "model/states/StateKeeping.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/commands/StateCommands.h"
#include "widgets/docks/TimelineDock.h"
#include "widgets/forms/FieldForm.h"
#include "widgets/state/Cues.h"
#include "widgets/timeline/TimelineLanes.h"
#include "widgets/timeline/TimelineView.h"

using namespace crowd;
using namespace crowd::widgets;

namespace {

constexpr int kTimelinePatienceMs = 10'000;

struct TimelineDesk : crowd::testing::Desk<TimelineDock>
{
    TimelineDesk()
    {
        window.addDockWidget(Qt::BottomDockWidgetArea, dock);
        window.resize(900, 320);
        state.transport().setPlaying(false);
        model::Scene scene = document.scene();
        model::Cue cue;
        cue.id = 4;
        cue.name = "Applause";
        cue.event = "clap";
        scene.cues = {cue};
        model::Rule rule;
        rule.id = 1;
        rule.name = "listen";
        model::triggers::Event event;
        event.event = "clap";
        rule.trigger = event;
        rule.actions = {model::actions::Stop()};
        scene.rules = {rule};
        document.replaceScene(std::move(scene), {});
        (void)crowd::testing::addPeople(document, 4);
    }
    [[nodiscard]] TimelineView& view() { return *dock->findChild<TimelineView*>(); }
    [[nodiscard]] const model::Timeline& marks() { return document.scene().timeline; }
    [[nodiscard]] QToolButton* button(const char* name)
    {
        return dock->findChild<QToolButton*>(QLatin1String(name));
    }
    /// In the lane, at a time.
    [[nodiscard]] QPoint at(model::MarkKind kind, double seconds)
    {
        model::Mark mark;
        mark.kind = kind;
        mark.seconds = seconds;
        return view().placeOf(mark);
    }
    void doubleClick(model::MarkKind kind, double seconds)
    {
        QTest::mouseDClick(&view(), Qt::LeftButton, {}, at(kind, seconds));
    }
    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mousePress(&view(), Qt::LeftButton, modifiers, from);
        for (int i = 1; i <= 4; ++i) {
            const QPoint between = from + (to - from) * i / 4;
            QMouseEvent move(QEvent::MouseMove, between, view().mapToGlobal(between), Qt::NoButton,
                             Qt::LeftButton, modifiers);
            QCoreApplication::sendEvent(&view(), &move);
        }
        QTest::mouseRelease(&view(), Qt::LeftButton, modifiers, to);
    }
    /// Frames of a clock that nobody else advances here.
    void playTo(double seconds)
    {
        state.transport().setPlaying(true);
        QVERIFY(QTest::qWaitFor(
            [&] {
                state.session().advance(0.02);
                return state.transport().seconds() >= seconds;
            },
            kTimelinePatienceMs));
        state.transport().setPlaying(false);
    }
};

bool isNear(double a, double b)
{
    return std::abs(a - b) < 0.06;
}

} // namespace

class TestTimelineDock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aDoubleClickMakesAMark();
    void aStateThatIsChosenIsRecalledAsItWouldBe();
    void marksAreDraggedAndCopied();
    void whatIsUndoneUnderTheHandIsLetGo();
    void theChosenAreRemoved();
    void theFormChangesTheMark();
    void whatIsPerformedIsRecorded();
    void aMarkThatIsAnotherIsPlayedAnew();
    void aMarkBeforeTheRunIsPlayedToo();
    void theRulerShowsWhatWasPlayed();
    void itGoesFromMarkToMark();
    void timesAreShownInFrames();
    void theWheelZooms();
    void noPageIsTurnedUnderTheHand();
    void aRangeIsPlayedOverAndOver();
    void aHandleThatIsClickedShowsThatMoment();
    void escapeGivesUpADrag();
    void itFollowsAJumpInTime();
    void playPausesAtTheEndOfTheRange();
    void aRunThatBeginsAfterTheRangePlaysOn();
    void whatIsSprayedIsOneMark();
    void theStripShowsWhatRulesDid();
    void whatIsWrongIsSaid();
    void marksAreCopiedByKeys();
    void theSideIsDrawnAwayAndBack();
    void anotherSceneHasItsOwn();
};

void TestTimelineDock::aDoubleClickMakesAMark()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    desk.doubleClick(model::MarkKind::Cue, 4.0);
    QCOMPARE(desk.marks().size(), std::size_t{1});
    QCOMPARE(desk.marks()[0].cue, 4U);
    QVERIFY(isNear(desk.marks()[0].seconds, 4.0));
    QVERIFY(desk.view().chosen() == MarkIds{1});
    QCOMPARE(markTitle(desk.document.scene(), desk.marks()[0]), QStringLiteral("Applause"));
    desk.doubleClick(model::MarkKind::Event, 6.0);
    QCOMPARE(desk.marks()[1].event, std::string("clap"));
    QString said;
    QObject::connect(&desk.state, &EditorState::statusMessage,
                     [&](const QString& text) { said = text; });
    desk.doubleClick(model::MarkKind::State, 8.0); // the scene has none
    QCOMPARE(desk.marks().size(), std::size_t{2});
    QVERIFY2(said.contains(QStringLiteral("no states yet")), qPrintable(said));
    desk.document.undoStack().undo();
    desk.document.undoStack().undo();
    QVERIFY(desk.marks().empty() && desk.view().chosen().empty());
}

/// As the panel States would recall it now.
void TestTimelineDock::aStateThatIsChosenIsRecalledAsItWouldBe()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    for (const char* name : {"calm", "wild"}) {
        QVERIFY(keepStateAs(desk.state, QLatin1String(name),
                            model::columnsOf(model::PropertyAspect::Size), StateReach::Everybody,
                            0));
    }
    const model::StateId wild = desk.document.scene().states[1].id;
    QCOMPARE(desk.state.chosenState(), wild);
    RecallSettings recall;
    recall.timing.seconds = 2.0F;
    recall.timing.stagger.seconds = 6.0F;
    desk.state.setRecall(recall);
    desk.doubleClick(model::MarkKind::State, 3.0);
    QCOMPARE(desk.marks().back().state, wild);
    QCOMPARE(desk.marks().back().fade, 2.0F);
    QCOMPARE(desk.marks().back().spread, 6.0F);
    desk.state.chooseState(0);
    desk.doubleClick(model::MarkKind::State, 6.0);
    QCOMPARE(desk.marks().back().state, desk.document.scene().states[0].id);
}

void TestTimelineDock::marksAreDraggedAndCopied()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    desk.doubleClick(model::MarkKind::Marker, 3.0);
    const int steps = desk.document.undoStack().index();
    desk.drag(desk.at(model::MarkKind::Marker, 3.0), desk.at(model::MarkKind::Marker, 7.0));
    QCOMPARE(desk.document.undoStack().index(), steps + 1);
    QVERIFY2(isNear(desk.marks()[0].seconds, 7.0),
             qPrintable(QString::number(desk.marks()[0].seconds)));
    desk.drag(desk.at(model::MarkKind::Marker, 7.0), desk.at(model::MarkKind::Marker, 9.0),
              Qt::ControlModifier);
    QCOMPARE(desk.marks().size(), std::size_t{2});
    QVERIFY(isNear(desk.marks()[0].seconds, 7.0) && isNear(desk.marks()[1].seconds, 9.0));
    QVERIFY(desk.view().chosen() == MarkIds{2});
    QTest::mouseClick(&desk.view(), Qt::LeftButton, Qt::ShiftModifier,
                      desk.at(model::MarkKind::Marker, 7.0));
    QVERIFY((desk.view().chosen() == MarkIds{1, 2}));
    desk.drag(desk.at(model::MarkKind::Marker, 9.0), desk.at(model::MarkKind::Marker, 1.0));
    QCOMPARE(desk.marks()[0].seconds, 0.0);        // none before the beginning
    QVERIFY(isNear(desk.marks()[1].seconds, 2.0)); // as far from the other as before
}

void TestTimelineDock::whatIsUndoneUnderTheHandIsLetGo()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    desk.doubleClick(model::MarkKind::Cue, 3.0);
    const QPoint from = desk.at(model::MarkKind::Cue, 3.0);
    QTest::mousePress(&desk.view(), Qt::LeftButton, {}, from);
    desk.document.undoStack().undo();
    const QPoint to = from + QPoint(90, 0);
    QMouseEvent move(QEvent::MouseMove, to, desk.view().mapToGlobal(to), Qt::NoButton,
                     Qt::LeftButton, {});
    QCoreApplication::sendEvent(&desk.view(), &move);
    QTest::mouseRelease(&desk.view(), Qt::LeftButton, {}, to);
    QVERIFY(desk.marks().empty());
    desk.document.undoStack().redo();
    model::Mark gone = desk.marks()[0];
    gone.cue = 99;
    QCOMPARE(markTitle(desk.document.scene(), gone), QStringLiteral("missing cue"));
}

void TestTimelineDock::theChosenAreRemoved()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    const std::size_t people = desk.document.scene().population.size();
    desk.state.selection().selectAll();
    desk.doubleClick(model::MarkKind::Marker, 3.0);
    desk.doubleClick(model::MarkKind::Marker, 5.0);
    QTest::keyClick(&desk.view(), Qt::Key_Delete);
    QCOMPARE(desk.marks().size(), std::size_t{1});
    QCOMPARE(desk.document.scene().population.size(), people);
    QVERIFY(!desk.button("markRemove")->isEnabled());
    QTest::mouseClick(&desk.view(), Qt::LeftButton, {}, desk.at(model::MarkKind::Marker, 3.0));
    QTest::mouseClick(desk.button("markRemove"), Qt::LeftButton);
    QVERIFY(desk.marks().empty());
}

void TestTimelineDock::theFormChangesTheMark()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    auto* form = desk.dock->findChild<FieldForm*>(QStringLiteral("markForm"));
    QVERIFY(!form->isVisible());
    desk.doubleClick(model::MarkKind::Marker, 3.0);
    QVERIFY(form->isVisible());
    auto* name = crowd::testing::fieldBeside<QLineEdit>(*desk.dock, QStringLiteral("Name"));
    QVERIFY(name != nullptr);
    crowd::testing::type(*name, QStringLiteral("Curtain"));
    QCOMPARE(desk.marks()[0].name, std::string("Curtain"));
    auto* then = crowd::testing::fieldBeside<QComboBox>(*desk.dock, QStringLiteral("Then"));
    QVERIFY(then != nullptr);
    QTest::keyClick(then, Qt::Key_Down);
    QVERIFY(desk.marks()[0].kind == model::MarkKind::Cue);
    desk.document.undoStack().undo();
    QVERIFY(desk.marks()[0].kind == model::MarkKind::Marker);
    QCOMPARE(then->currentIndex(), 0);
}

void TestTimelineDock::whatIsPerformedIsRecorded()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    desk.playTo(0.2);
    sendCue(desk.state, desk.document.scene().cues[0]); // nobody records
    QTest::mouseClick(desk.button("timelineRecord"), Qt::LeftButton);
    QVERIFY(desk.state.session().recorder().isOn());
    desk.playTo(0.5);
    sendCue(desk.state, desk.document.scene().cues[0]);
    const std::vector<model::IndividualId> some{1, 2};
    desk.state.session().send({"wave", 2.0F}, some);
    QTRY_COMPARE_WITH_TIMEOUT(desk.marks().size(), std::size_t{2}, kTimelinePatienceMs);
    const model::Mark cue = desk.marks()[0];
    QVERIFY(cue.kind == model::MarkKind::Cue && cue.cue == 4 && cue.people.empty());
    QVERIFY(cue.seconds >= 0.5 && cue.seconds < 1.5);
    const model::Mark event = desk.marks()[1];
    QVERIFY(event.kind == model::MarkKind::Event && event.event == "wave");
    QVERIFY((event.people == std::vector<int>{1, 2}) && event.payload == 2.0F);
    desk.playTo(cue.seconds + 0.3);
    const auto fired = desk.state.session().firedCount(1);
    QVERIFY(fired > 0);
    // Played again it happens by itself.
    desk.state.session().recorder().setOn(false);
    desk.state.session().stop();
    desk.playTo(cue.seconds + 0.3);
    QTRY_COMPARE_WITH_TIMEOUT(desk.state.session().firedCount(1), fired / 2, kTimelinePatienceMs);
    QCOMPARE(desk.marks().size(), std::size_t{2});
    desk.document.undoStack().undo();
    QVERIFY(desk.marks().empty());
}

/// What comes after it happens anew, and the moment that is shown stays.
void TestTimelineDock::aMarkThatIsAnotherIsPlayedAnew()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    const auto fired = [&desk] { return desk.state.session().firedCount(1); };
    QVERIFY(addMark(desk.state, model::MarkKind::Cue, 1.0) != 0);
    model::Mark mark = desk.marks()[0];
    mark.cue = 4;
    desk.document.edit(QStringLiteral("Cue"), [&mark](model::SceneEdit& edit) {
        edit.set<model::members::Timeline>({mark});
    });
    desk.playTo(2.0);
    QTRY_COMPARE_WITH_TIMEOUT(fired(), std::uint64_t{4}, kTimelinePatienceMs);
    const double shown = desk.state.transport().seconds();
    const auto isListed = [&desk](double from, double to) {
        const auto all = desk.state.session().firings().since(0);
        return std::ranges::count_if(all, [from, to](const behavior::RuleFired& each) {
            return each.seconds >= from && each.seconds <= to;
        });
    };
    QCOMPARE(isListed(0.9, 1.2), 4);
    mark.seconds = 1.5;
    desk.document.edit(QStringLiteral("Later"), [&mark](model::SceneEdit& edit) {
        edit.set<model::members::Timeline>({mark});
    });
    QCOMPARE(desk.state.transport().seconds(), shown);
    QTRY_COMPARE_WITH_TIMEOUT(isListed(1.4, 1.7), 4, kTimelinePatienceMs);
    QCOMPARE(isListed(0.0, 1.4), 0);
    QCOMPARE(desk.state.session().liveSeconds(), shown);
    desk.drag(desk.at(model::MarkKind::Cue, 1.5), desk.at(model::MarkKind::Cue, 7.0));
    QVERIFY2(isNear(desk.marks()[0].seconds, 7.0),
             qPrintable(QString::number(desk.marks()[0].seconds)));
    QTRY_COMPARE_WITH_TIMEOUT(fired(), std::uint64_t{0}, kTimelinePatienceMs);
    QCOMPARE(desk.state.transport().seconds(), shown);
    desk.document.undoStack().undo();
    desk.document.undoStack().undo(); // the next one before the first is done
    QTRY_COMPARE_WITH_TIMEOUT(isListed(0.9, 1.2), 4, kTimelinePatienceMs);
    QCOMPARE(fired(), std::uint64_t{4});
    // From an earlier moment on: all that was played can be seen again, as it is now.
    desk.state.transport().setSeconds(0.5);
    mark.seconds = 1.3;
    desk.document.edit(QStringLiteral("Other"), [&mark](model::SceneEdit& edit) {
        edit.set<model::members::Timeline>({mark});
    });
    QCOMPARE(desk.state.session().liveSeconds(), shown);
    QTRY_COMPARE_WITH_TIMEOUT(isListed(1.2, 1.5), 4, kTimelinePatienceMs);
    QCOMPARE(isListed(0.9, 1.1), 0);
    // A name for a moment, or for a mark, changes nothing.
    const auto number = desk.state.session().firings().begin();
    (void)addMark(desk.state, model::MarkKind::Marker, 0.5);
    QCOMPARE(desk.state.session().firings().begin(), number);
}

/// The run that a mark begins late has what marks before it do, and all of it can be seen again.
void TestTimelineDock::aMarkBeforeTheRunIsPlayedToo()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    model::Scene scene = desk.document.scene();
    model::Rule rule = std::exchange(scene.rules, {})[0];
    desk.document.replaceScene(std::move(scene), {});
    desk.playTo(2.0);
    SessionControl& session = desk.state.session();
    QVERIFY(!session.isRunning());
    desk.document.edit(QStringLiteral("Rule"), [&rule](model::SceneEdit& edit) {
        edit.set<model::members::Rules>({rule});
    });
    desk.playTo(2.3);
    QVERIFY(session.isRunning());
    const double begun = session.posedSince();
    QVERIFY2(begun >= 2.0, qPrintable(QString::number(begun)));
    QCOMPARE(session.firstSeconds(), 0.0);
    desk.drag(desk.view().placeOf(2.3), desk.view().placeOf(1.0));
    QVERIFY(isNear(desk.state.transport().seconds(), 1.0)); // as it was seen then
    QVERIFY(session.lit().empty() && session.isRunning());
    session.catchUp();
    const double shown = desk.state.transport().seconds();
    const auto mark = [&desk](double seconds) {
        model::Mark one;
        one.id = 1;
        one.kind = model::MarkKind::Cue;
        one.cue = 4;
        one.seconds = seconds;
        desk.document.edit(QStringLiteral("Cue"), [&one](model::SceneEdit& edit) {
            edit.set<model::members::Timeline>({one});
        });
    };
    const auto fired = [&session] { return session.firedCount(1); };
    mark(1.0);
    QTRY_COMPARE_WITH_TIMEOUT(fired(), std::uint64_t{4}, kTimelinePatienceMs);
    QCOMPARE(session.posedSince(), 0.0);
    QCOMPARE(desk.state.transport().seconds(), shown);
    mark(0.0); // also where the run begins
    QTRY_VERIFY_WITH_TIMEOUT(!session.firings().since(0).empty() &&
                                 session.firings().since(0).front().seconds < 0.5,
                             kTimelinePatienceMs);
    QCOMPARE(desk.state.transport().seconds(), shown);
    // What is done before a run that began later begins it there.
    session.stop();
    desk.document.undoStack().undo();
    desk.document.undoStack().undo();
    desk.state.transport().setSeconds(2.0);
    desk.playTo(2.3);
    QVERIFY(session.posedSince() >= 2.0);
    desk.drag(desk.view().placeOf(2.3), desk.view().placeOf(1.0));
    session.takeFromHere();
    QVERIFY(isNear(session.posedSince(), 1.0) && isNear(session.liveSeconds(), 1.0));
}

void TestTimelineDock::theRulerShowsWhatWasPlayed()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    desk.playTo(2.0);
    const double live = desk.state.session().liveSeconds();
    desk.drag(desk.view().placeOf(0.5), desk.view().placeOf(1.0));
    QVERIFY(isNear(desk.state.transport().seconds(), 1.0));
    desk.drag(desk.view().placeOf(1.0), desk.view().placeOf(live + 5.0));
    QCOMPARE(desk.state.transport().seconds(), live);
}

void TestTimelineDock::itGoesFromMarkToMark()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    desk.playTo(2.0);
    const double live = desk.state.session().liveSeconds();
    (void)addMark(desk.state, model::MarkKind::Marker, 0.5);
    (void)addMark(desk.state, model::MarkKind::Marker, 1.5);
    (void)addMark(desk.state, model::MarkKind::Marker, 60.0);
    QTest::mouseClick(desk.button("markBack"), Qt::LeftButton);
    QCOMPARE(desk.state.transport().seconds(), 1.5);
    QTest::mouseClick(desk.button("markBack"), Qt::LeftButton);
    QTest::mouseClick(desk.button("markBack"), Qt::LeftButton); // there is none
    QCOMPARE(desk.state.transport().seconds(), 0.5);
    QTest::mouseClick(desk.button("markNext"), Qt::LeftButton);
    QCOMPARE(desk.state.transport().seconds(), 1.5);
    QTest::mouseClick(desk.button("markNext"), Qt::LeftButton); // not played yet
    QCOMPARE(desk.state.transport().seconds(), live);
    QTest::mouseClick(desk.button("markAdd"), Qt::LeftButton);
    QCOMPARE(desk.marks().back().seconds, live);
}

void TestTimelineDock::timesAreShownInFrames()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    auto* units = desk.dock->findChild<QComboBox*>(QStringLiteral("timelineUnits"));
    units->setCurrentIndex(units->findData(25));
    desk.doubleClick(model::MarkKind::Marker, 3.333);
    const double frames = desk.marks()[0].seconds * 25.0;
    QVERIFY(std::abs(frames - std::round(frames)) < 1e-9);
    TimelineDesk other; // it is remembered
    QCOMPARE(other.view().frameRate(), 25);
    units->setCurrentIndex(0);
    QCOMPARE(desk.view().frameRate(), 0);
}

void TestTimelineDock::theWheelZooms()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    const int before = desk.view().placeOf(5.0).x();
    const QPoint at = desk.view().placeOf(0.0);
    const auto turn = [&](int by, Qt::KeyboardModifiers modifiers) {
        QWheelEvent event(at, desk.view().mapToGlobal(at), {}, {0, by}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&desk.view(), &event);
    };
    turn(360, {});
    QCOMPARE(desk.view().placeOf(0.0).x(), at.x());
    QVERIFY(desk.view().placeOf(5.0).x() > before + 20);
    turn(-360, Qt::ShiftModifier);
    QVERIFY(desk.view().placeOf(0.0).x() < at.x() - 50);
    QTest::mouseClick(desk.button("timelineAll"), Qt::LeftButton);
    QCOMPARE(desk.view().placeOf(0.0).x(), at.x());
}

void TestTimelineDock::noPageIsTurnedUnderTheHand()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    TimelineView& view = desk.view();
    const QPoint begin = view.placeOf(0.0);
    QWheelEvent closer(begin, view.mapToGlobal(begin), {}, {0, 6000}, Qt::NoButton, {},
                       Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view, &closer);
    QVERIFY(view.placeOf(2.0).x() > view.width());

    Transport& transport = desk.state.transport();
    const auto playTo = [&](double seconds) {
        transport.setPlaying(true);
        return QTest::qWaitFor(
            [&] {
                const QPoint at(view.width() / 2, 3 + static_cast<int>(transport.seconds()));
                QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton,
                                 Qt::NoButton, {});
                QCoreApplication::sendEvent(&view, &move);
                desk.state.session().advance(0.02);
                return transport.seconds() >= seconds;
            },
            kTimelinePatienceMs);
    };
    QVERIFY(playTo(2.0));
    QCOMPARE(view.placeOf(0.0), begin);

    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&view, &leave);
    desk.playTo(2.2);
    const int now = view.placeOf(transport.seconds()).x();
    QVERIFY(now >= begin.x() && now < view.width());
    QVERIFY(view.placeOf(0.0).x() < begin.x());
}

void TestTimelineDock::aRangeIsPlayedOverAndOver()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    const auto range = [&desk] { return desk.document.scene().playRange; };
    desk.drag(desk.view().placeOf(1.0), desk.view().placeOf(2.0), Qt::ShiftModifier);
    QVERIFY(isNear(range().begin, 1.0) && isNear(range().end, 2.0) && !range().isLoop);
    QTest::mouseClick(desk.button("playLoop"), Qt::LeftButton);
    QVERIFY(range().isLoop && isNear(range().end, 2.0));
    // The handle stands before the end.
    desk.drag(desk.view().placeOf(range().end) + QPoint(-2, 4),
              desk.view().placeOf(1.5) + QPoint(0, 4));
    QVERIFY(isNear(range().begin, 1.0) && isNear(range().end, 1.5));
    desk.playTo(1.3);
    const double latest = range().end;
    desk.state.transport().setPlaying(true);
    bool hasBegunAgain = false;
    double before = desk.state.transport().seconds();
    const bool isOver = QTest::qWaitFor(
        [&] {
            desk.state.session().advance(0.02);
            const double now = desk.state.transport().seconds();
            hasBegunAgain = hasBegunAgain || now < before;
            before = now;
            return hasBegunAgain && now > 1.3;
        },
        kTimelinePatienceMs);
    QVERIFY(isOver && desk.state.transport().isPlaying());
    QVERIFY(desk.state.session().liveSeconds() <= latest + 1e-9); // nothing new was played
    desk.document.undoStack().undo();
    QVERIFY(isNear(range().end, 2.0) && range().isLoop);
    desk.document.undoStack().undo();
    QVERIFY(!desk.button("playLoop")->isChecked());
    QTest::mouseClick(desk.button("playLoop"), Qt::LeftButton);
    setPlayRange(desk.state, {});
    QVERIFY(!range().isSet() && !desk.button("playLoop")->isChecked());
}

void TestTimelineDock::aHandleThatIsClickedShowsThatMoment()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    setPlayRange(desk.state, {.begin = 1.0, .end = 2.0});
    desk.playTo(1.0);
    desk.state.transport().setSeconds(0.2);
    const int steps = desk.document.undoStack().count();
    const QPoint handle = desk.view().placeOf(1.0) + QPoint(1, 4);
    QTest::mouseClick(&desk.view(), Qt::LeftButton, {}, handle);
    QVERIFY(isNear(desk.state.transport().seconds(), 1.0));
    QCOMPARE(desk.document.scene().playRange.begin, 1.0);
    QCOMPARE(desk.document.undoStack().count(), steps);
}

void TestTimelineDock::escapeGivesUpADrag()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    desk.doubleClick(model::MarkKind::Cue, 1.0);
    setPlayRange(desk.state, {.begin = 1.0, .end = 2.0});
    const model::Timeline marks = desk.document.scene().timeline;
    const auto chosen = desk.view().chosen();
    QCOMPARE(marks.size(), std::size_t{1});
    const QPoint mark = desk.at(model::MarkKind::Cue, 1.0);
    const QPoint handle = desk.view().placeOf(2.0) + QPoint(-2, 4);
    for (const QPoint from : {mark, handle}) {
        QTest::mousePress(&desk.view(), Qt::LeftButton, {}, from);
        const QPoint to = from + QPoint(60, 0);
        QMouseEvent move(QEvent::MouseMove, to, desk.view().mapToGlobal(to), Qt::NoButton,
                         Qt::LeftButton, {});
        QCoreApplication::sendEvent(&desk.view(), &move);
        // Whoever has the keys: the form of what was chosen must not have taken them.
        QWidget* const hasKeys = QApplication::focusWidget();
        QTest::keyClick(hasKeys != nullptr ? hasKeys : &desk.view(), Qt::Key_Escape);
        QTest::mouseRelease(&desk.view(), Qt::LeftButton, {}, to);
        QVERIFY(desk.document.scene().timeline == marks);
        QCOMPARE(desk.document.scene().playRange.end, 2.0);
    }
    QVERIFY(desk.view().chosen().empty()); // the press beside it
    QVERIFY(!chosen.empty());
}

void TestTimelineDock::itFollowsAJumpInTime()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    const int right = desk.view().width();
    desk.state.transport().setSeconds(1000.0);
    QVERIFY(desk.view().placeOf(1000.0).x() < right);
    QVERIFY(desk.view().placeOf(0.0).x() < 0);
    desk.state.transport().setSeconds(0.0);
    QVERIFY(desk.view().placeOf(0.0).x() >= 0 && desk.view().placeOf(0.0).x() < right);
}

void TestTimelineDock::playPausesAtTheEndOfTheRange()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    beginPlayRange(desk.state, 0.2);
    endPlayRange(desk.state, 0.6);
    Transport& transport = desk.state.transport();
    const auto play = [&] {
        transport.setPlaying(true);
        return QTest::qWaitFor(
            [&] {
                desk.state.session().advance(0.02);
                return !transport.isPlaying();
            },
            kTimelinePatienceMs);
    };
    QSignalSpy ended(&desk.state.session(), &SessionControl::rangeEnded);
    QVERIFY(play());
    QCOMPARE(transport.seconds(), 0.6);
    QCOMPARE(ended.count(), 1); // it is said why
    transport.setPlaying(true); // from its beginning
    desk.state.session().advance(0.02);
    QVERIFY2(transport.seconds() < 0.3, qPrintable(QString::number(transport.seconds())));
    QVERIFY(play());
    QCOMPARE(transport.seconds(), 0.6);
    showRangeEdge(desk.state, false);
    QCOMPARE(transport.seconds(), 0.2);
    showRangeEdge(desk.state, true);
    QCOMPARE(transport.seconds(), 0.6);
}

void TestTimelineDock::aRunThatBeginsAfterTheRangePlaysOn()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    setPlayRange(desk.state, {.begin = 1.0, .end = 2.0, .isLoop = true});
    desk.state.transport().setSeconds(5.0);
    desk.playTo(5.5);
    QVERIFY(desk.state.session().isRunning() && desk.state.transport().seconds() >= 5.5);
}

void TestTimelineDock::whatIsSprayedIsOneMark()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    desk.state.session().recorder().setOn(true);
    desk.playTo(0.3);
    {
        const auto edit = desk.document.beginEdit(); // as a stroke has it
        QVERIFY(edit.isOk());
        desk.state.session().send({"wave", 2.0F}, std::vector<model::IndividualId>{2});
        desk.playTo(0.8);
        desk.state.session().send({"wave", 2.0F}, std::vector<model::IndividualId>{1, 4});
        desk.playTo(1.0);
        desk.state.session().send({"wave", 2.0F}, std::vector<model::IndividualId>{2}); // once more
        desk.playTo(1.4);
    }
    QTRY_COMPARE_WITH_TIMEOUT(desk.marks().size(), std::size_t{2}, kTimelinePatienceMs);
    const model::Mark& sprayed = desk.marks()[0];
    QVERIFY((sprayed.people == std::vector<int>{1, 2, 4}) && sprayed.delays.size() == 3);
    QVERIFY(sprayed.delays[1] == 0 && sprayed.delays[0] >= 300);
    QCOMPARE(sprayed.delays[0], sprayed.delays[2]);
    QVERIFY((desk.marks()[1].people == std::vector<int>{2}) && desk.marks()[1].delays.empty());
}

void TestTimelineDock::theStripShowsWhatRulesDid()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    desk.state.selection().set(std::vector<model::IndividualId>{1, 2});
    desk.playTo(0.5);
    desk.state.session().send({"clap", 0.0F}, std::vector<model::IndividualId>{1, 2, 3});
    desk.playTo(1.2);
    const FiringHistory& firings = desk.state.session().firings();
    QTRY_COMPARE_WITH_TIMEOUT(firings.since(0).size(), std::size_t{3}, kTimelinePatienceMs);
    const double when = firings.since(0)[0].seconds;
    QVERIFY(when >= 0.5 && when < 1.2);
    const QPoint tick(desk.view().placeOf(when).x() + 1,
                      TimelineLayout{desk.view().size()}.stripTop() + TimelineLayout::kStrip / 2);
    const auto isShown = [&] {
        const QColor seen = desk.view().grab().toImage().pixelColor(tick);
        return seen.hsvSaturation() > 120;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isShown(), kTimelinePatienceMs);
    QTest::mouseMove(&desk.view(), tick);
    QTRY_VERIFY_WITH_TIMEOUT(desk.view().toolTip().startsWith(QStringLiteral("listen, at ")),
                             kTimelinePatienceMs);
    desk.state.selection().set(std::vector<model::IndividualId>{4}); // heard nothing
    QTRY_VERIFY_WITH_TIMEOUT(!isShown(), kTimelinePatienceMs);
}

void TestTimelineDock::whatIsWrongIsSaid()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    auto* note = desk.dock->findChild<QLabel*>(QStringLiteral("markNote"));
    desk.doubleClick(model::MarkKind::Cue, 4.0);
    QVERIFY(note->text().isEmpty());
    model::Timeline timeline = desk.marks();
    timeline[0].cue = 99;
    desk.document.edit(QStringLiteral("away"), [&](model::SceneEdit& edit) {
        edit.set<model::members::Timeline>(timeline);
    });
    QVERIFY2(note->text().contains(QStringLiteral("a cue that is not there")),
             qPrintable(note->text()));
    QVERIFY(note->isVisible());
    desk.view().choose({});
    QVERIFY(note->text().contains(QStringLiteral("a cue that is not there")));
    desk.document.undoStack().undo();
    QVERIFY(!note->text().contains(QStringLiteral("⚠")));
}

/// The first of them to the moment that is shown, also twice.
void TestTimelineDock::marksAreCopiedByKeys()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    desk.doubleClick(model::MarkKind::Cue, 1.0);
    desk.doubleClick(model::MarkKind::Marker, 2.0);
    QCOMPARE(desk.marks().size(), std::size_t{2});
    desk.playTo(1.5);
    const double now = desk.state.transport().seconds();
    desk.view().choose({desk.marks()[0].id, desk.marks()[1].id});
    desk.view().setFocus();
    QTest::keyClick(&desk.view(), Qt::Key_C, Qt::ControlModifier);
    QTest::keyClick(&desk.view(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(desk.marks().size(), std::size_t{4});
    const double earlier = std::min(desk.marks()[0].seconds, desk.marks()[1].seconds);
    const double later = std::max(desk.marks()[0].seconds, desk.marks()[1].seconds);
    const auto isThere = [&](double seconds) {
        return std::ranges::any_of(desk.marks(), [&](const model::Mark& mark) {
            return std::abs(mark.seconds - seconds) < 1e-6;
        });
    };
    QVERIFY(isThere(now));
    QVERIFY(isThere(now + later - earlier));
    QCOMPARE(desk.view().chosen().size(), std::size_t{2});
    desk.document.undoStack().undo();
    QCOMPARE(desk.marks().size(), std::size_t{2});
}

/// By its border, to the edge and back; and the next timeline has it as it was left.
void TestTimelineDock::theSideIsDrawnAwayAndBack()
{
    const auto drag = [](QSplitter& halves, int by) {
        QWidget* handle = halves.handle(1);
        const QPoint from = handle->rect().center();
        QTest::mousePress(handle, Qt::LeftButton, {}, from);
        QTest::mouseMove(handle, from + QPoint(by, 0));
        QTest::mouseRelease(handle, Qt::LeftButton, {}, from + QPoint(by, 0));
    };
    {
        TimelineDesk desk;
        QVERIFY(desk.isReady());
        auto* halves = desk.dock->findChild<QSplitter*>();
        const auto* note = desk.dock->findChild<QLabel*>(QStringLiteral("markNote"));
        QTRY_VERIFY(!note->visibleRegion().isEmpty());
        const int before = desk.view().width();
        drag(*halves, 400);
        QTRY_VERIFY(note->visibleRegion().isEmpty());
        QVERIFY(desk.view().width() > before);
    }
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    const auto* note = desk.dock->findChild<QLabel*>(QStringLiteral("markNote"));
    QVERIFY(note->visibleRegion().isEmpty());
    drag(*desk.dock->findChild<QSplitter*>(), -240);
    QTRY_VERIFY(!note->visibleRegion().isEmpty());
}

void TestTimelineDock::anotherSceneHasItsOwn()
{
    TimelineDesk desk;
    QVERIFY(desk.isReady());
    desk.state.session().recorder().setOn(true);
    desk.doubleClick(model::MarkKind::Marker, 3.0);
    desk.document.replaceScene(crowd::testing::smallTheatre(), {});
    QVERIFY(desk.view().chosen().empty());
    QVERIFY(!desk.dock->findChild<FieldForm*>(QStringLiteral("markForm"))->isVisible());
}

CROWD_WINDOW_TEST(TestTimelineDock)
#include "tst_TimelineDock.moc"
