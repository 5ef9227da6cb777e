// SPDX-License-Identifier: MIT
#include <cmath>

#include <QtCore/QDir>
#include <QtCore/QFileInfo>
#include <QtGui/QUndoStack>
#include <QtTest/QTest>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QSlider>
#include <QtWidgets/QToolButton>

#include "app/window/DockLayout.h"
#include "tests/app/SceneWindow.h"
#include "tests/program/WindowTest.h"
#include "widgets/state/Cues.h"
#include "widgets/state/SessionControl.h"
#include "widgets/state/TakeShelf.h"

using namespace crowd;
using namespace crowd::testing;

/// Runs that are kept, shown again and compared, in the real window.
class TestTakes : public QObject, private SceneWindow
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { prepare("tst_Takes"); }
    void init() { begin(); }
    void cleanup();
    void aRunIsKeptAndShownAgain();
    void itPlaysToItsEndAndFromItsBeginning();
    void nobodyIsToldAnythingMeanwhile();
    void anotherIsSeenAsGhosts();
    void whoIsHiddenIsCountedApart();
    void nothingToKeepIsSaid();
    void aRunGoesOnOutOfIt();
    void someActAgainAndOthersDoWhatTheyDid();
    void theyArePaintedToDoSo();
    void twoAreComparedFromBeginningToEnd();
    void peopleOfItAreEditedByHand();
    void oneOfThemIsSomebodyElse();
    void editsSurviveARetakeAndAFile();
    void thePanelShowsRenamesAndRemoves();
    void itIsThereAfterSavingAndOpening();
    void oneWhoseFileIsGoneSaysSo();

private:
    [[nodiscard]] widgets::EditorState& state() const { return m_window->state(); }
    [[nodiscard]] widgets::Transport& transport() const { return state().transport(); }
    [[nodiscard]] widgets::SessionControl& session() const { return state().session(); }
    [[nodiscard]] const model::Takes& takes() const { return document().scene().takes; }
    [[nodiscard]] float xAt(double seconds, std::size_t row = 0) const;
    void press(Qt::Key key) const;
    template<class Widget>
    [[nodiscard]] Widget* child(const char* name) const
    {
        return m_window->findChild<Widget*>(QString::fromLatin1(name));
    }
    /// Somebody walks to the right for a second and a half; of several, each `apart` metres before
    /// the one before.
    void play(std::size_t people = 1, float apart = 0.0F);
    /// Where he is seen at the moment shown.
    [[nodiscard]] QPoint pixelOf(std::size_t row) const;
    void keep();
    /// From now on he would walk the other way.
    void turnPath();
    void showPanel();
};

void TestTakes::cleanup()
{
    document().undoStack().setClean();
    m_window.reset();
}

float TestTakes::xAt(double seconds, std::size_t row) const
{
    transport().setSeconds(seconds);
    return state().frame()->population.column(model::columns::position)[row].x;
}

void TestTakes::press(Qt::Key key) const
{
    QTest::keyClick(m_window.get(), key, Qt::ControlModifier | Qt::AltModifier);
}

QPoint TestTakes::pixelOf(std::size_t row) const
{
    const glm::vec3 foot = state().frame()->population.column(model::columns::position)[row];
    const model::View view(state().camera(), state().viewSize());
    const glm::vec3 pixel = view.project(foot + glm::vec3(0.0F, 1.0F, 0.0F)).value();
    return {static_cast<int>(pixel.x), static_cast<int>(pixel.y)};
}

void TestTakes::play(std::size_t people, float apart)
{
    model::Scene scene = plainScene(people);
    scene.places = {{1, "here", {0.0F, 0.0F, 0.0F}, 1.0F}, {2, "there", {60.0F, 0.0F, 0.0F}, 1.0F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1, 2}}};
    scene.cues = {{1, "Go", "go", 1.0F, ""}};
    const auto ids = scene.population.ids();
    std::vector<glm::vec3> spots(people);
    for (std::size_t i = 0; i < people; ++i) {
        spots[i].z = apart * static_cast<float>(i);
    }
    scene.population.setValues<glm::vec3>(model::columns::position,
                                          std::vector(ids.begin(), ids.end()), spots);
    const model::PathId path = 1;
    scene.population.setValues<model::PathId>(
        model::columns::path, std::vector(ids.begin(), ids.end()), std::vector(ids.size(), path));
    openScene(scene, QStringLiteral("walk.crowd"));
    session().stop();
    transport().setSpeed(4.0);
    transport().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(session().isRunning() && transport().seconds() > 1.5, kPatienceMs);
    transport().setPlaying(false);
}

void TestTakes::keep()
{
    const std::size_t before = takes().size();
    QTest::keyClick(m_window.get(), Qt::Key_Return, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE_WITH_TIMEOUT(takes().size(), before + 1, kPatienceMs);
}

void TestTakes::turnPath()
{
    document().edit(QStringLiteral("Turn"), [](model::SceneEdit& edit) {
        model::Place there = *edit.scene().findPlace(2);
        there.position.x = -60.0F;
        edit.changePlace(there);
    });
}

void TestTakes::showPanel()
{
    QDockWidget* dock = m_window->dockLayout().dock(app::DockId::Takes);
    dock->show();
    dock->raise();
    QTRY_VERIFY(child<QListWidget>("takesList")->isVisible());
}

void TestTakes::aRunIsKeptAndShownAgain()
{
    play();
    const float early = xAt(0.5);
    const float later = xAt(1.2);
    QVERIFY(later > early + 0.3F);
    transport().setSeconds(session().liveSeconds());
    keep();
    const model::Take take = takes().front();
    QCOMPARE(take.name, std::string("Take 1"));
    QCOMPARE(take.people, 1);
    QVERIFY(take.end > 1.2 && !take.isShown);
    QVERIFY(QFileInfo::exists(pathOf(QStringLiteral("walk.takes/")) +
                              QString::fromStdString(take.file)));
    QVERIFY(session().isRunning()); // keeping is no more than that

    turnPath();
    session().stop();
    press(Qt::Key_N);
    QCOMPARE(session().take(), take.id);
    QVERIFY(!session().isRunning() && session().isPosed());
    QCOMPARE(xAt(0.5), early);
    QCOMPARE(xAt(1.2), later);
    press(Qt::Key_N); // after the last one the scene as it plays
    QCOMPARE(session().take(), model::TakeId{0});
    QVERIFY(!session().isPosed());
    document().undoStack().undo();
    QCOMPARE(session().take(), take.id);
    QCOMPARE(xAt(0.5), early);
    document().undoStack().undo(); // it is shown no more
    QCOMPARE(session().take(), model::TakeId{0});
}

void TestTakes::itPlaysToItsEndAndFromItsBeginning()
{
    play();
    keep();
    transport().setSeconds(takes().front().end);
    press(Qt::Key_N);
    QCOMPARE(transport().seconds(), takes().front().begin); // from where it can be played
    const double end = takes().front().end;
    transport().setSpeed(8.0);
    transport().setSeconds(end - 0.5);
    transport().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(!transport().isPlaying(), kPatienceMs);
    QCOMPARE(transport().seconds(), end);
    transport().setSpeed(0.1);
    transport().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(transport().seconds() < end / 2.0, kPatienceMs);
    QVERIFY(transport().isPlaying());
    m_window->actions().action("stop")->trigger();
    QCOMPARE(transport().seconds(), takes().front().begin);
    QCOMPARE(session().take(), takes().front().id); // it is still what is shown
    m_window->actions().action("step")->trigger();
    QVERIFY(transport().seconds() > takes().front().begin && transport().seconds() < 0.1);
    m_window->actions().action("step-back")->trigger();
    QCOMPARE(transport().seconds(), takes().front().begin);
    // A loop within it.
    document().edit(QStringLiteral("Loop"), [](model::SceneEdit& edit) {
        edit.set<model::members::Range>({.begin = 0.5, .end = 0.9, .isLoop = true});
    });
    transport().setSpeed(1.0);
    transport().setSeconds(0.85);
    transport().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(transport().seconds() < 0.7, kPatienceMs);
    QVERIFY(transport().seconds() >= 0.5 && transport().isPlaying());
}

void TestTakes::nobodyIsToldAnythingMeanwhile()
{
    play();
    keep();
    press(Qt::Key_N);
    QString said;
    connect(&state(), &widgets::EditorState::statusMessage, this,
            [&said](const QString& text) { said = text; });
    transport().setSeconds(0.2);
    transport().setPlaying(true);
    widgets::sendCue(state(), document().scene().cues.front());
    QVERIFY2(said.contains(QStringLiteral("Take 1")), qPrintable(said));
    QVERIFY(!session().isRunning());
    // Nor is another take made of a take.
    m_window->actions().action("keep-take")->trigger();
    QCOMPARE(takes().size(), std::size_t{1});
    // How people look is the scene's all the same.
    QVERIFY(session().keepPose());
    transport().setPlaying(false);
}

void TestTakes::anotherIsSeenAsGhosts()
{
    play();
    transport().setSeconds(session().liveSeconds());
    keep();
    turnPath();
    session().stop();
    transport().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(session().isRunning() && transport().seconds() > 1.3, kPatienceMs);
    transport().setPlaying(false);
    showPanel();
    auto* list = child<QListWidget>("takesList");
    QCOMPARE(list->count(), 2);
    list->setCurrentRow(1);
    child<QToolButton>("ghostTake")->click();
    QCOMPARE(state().takes().ghost(), takes().front().id);
    const double now = transport().seconds();
    const auto other = state().takes().ghostFrame(now);
    QVERIFY(other);
    const auto found = widgets::differenceOf(*session().frame(now), *other);
    QCOMPARE(found.rows.size(), std::size_t{1});
    QVERIFY(found.most > 1.0F);
    auto* figures = child<QLabel>("takesDifference");
    QVERIFY(figures->isVisible());
    QVERIFY2(figures->text().contains(QStringLiteral("1 of 1")), qPrintable(figures->text()));
    // At its beginning both are the same.
    transport().setSeconds(session().firstSeconds());
    QTRY_VERIFY(figures->text().contains(QStringLiteral("everybody is as in")));
    child<QToolButton>("ghostTake")->click();
    QCOMPARE(state().takes().ghost(), model::TakeId{0});
    QVERIFY(!figures->isVisible());
}

/// Who is hidden in one of them is nowhere, not a hundred kilometres away.
void TestTakes::whoIsHiddenIsCountedApart()
{
    play(2, 1.0F);
    keep();
    keep();
    showPanel();
    press(Qt::Key_N);
    auto* list = child<QListWidget>("takesList");
    QCOMPARE(list->currentRow(), 1); // what is seen is what is chosen
    transport().setSeconds(1.0);
    list->setCurrentRow(2);
    child<QToolButton>("ghostTake")->click();
    auto* figures = child<QLabel>("takesDifference");
    QTRY_VERIFY2(figures->text().contains(QStringLiteral("everybody is as in")),
                 qPrintable(figures->text()));
    const auto hidden = static_cast<int>(document().scene().population.ids()[0]);
    document().edit(QStringLiteral("Hide"), [hidden](model::SceneEdit& edit) {
        model::Takes all = edit.scene().takes;
        model::HandEdit hide;
        hide.kind = model::HandEditKind::Hide;
        hide.people = {hidden};
        all[0].edits.push_back(std::move(hide));
        edit.set<model::members::Takes>(std::move(all));
    });
    const auto found = widgets::differenceOf(*session().frame(transport().seconds()),
                                             *state().takes().ghostFrame(transport().seconds()));
    QCOMPARE(found.rows.size(), std::size_t{0});
    QCOMPARE(found.absent, std::vector<std::size_t>{0});
    QTRY_VERIFY2(figures->text().contains(QStringLiteral("one of them only")),
                 qPrintable(figures->text()));
    auto* whole = child<QLabel>("takeFigures");
    QTRY_VERIFY2(whole->text().contains(QStringLiteral("one of them only")),
                 qPrintable(whole->text()));
}

/// Keys that can do nothing say why.
void TestTakes::nothingToKeepIsSaid()
{
    openScene(plainScene(2), QStringLiteral("still.crowd"));
    QSignalSpy said(&state(), &widgets::EditorState::statusMessage);
    QTest::keyClick(m_window.get(), Qt::Key_Return, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(said.count(), 1);
    QVERIFY(said.back()[0].toString().contains(QStringLiteral("nothing to keep")));
    QVERIFY(takes().empty());
}

/// By its keys: with what is edited now, after what was seen until then; and again from before
/// that.
void TestTakes::aRunGoesOnOutOfIt()
{
    play();
    const float early = xAt(0.3);
    const float begun = xAt(0.9);
    transport().setSeconds(session().liveSeconds());
    keep();
    showPanel();
    auto* button = child<QToolButton>("goOnOutOfTake");
    QVERIFY(!button->isEnabled()); // out of a take alone
    const model::Take take = takes().front();
    press(Qt::Key_N);
    turnPath(); // he would go the other way
    transport().setSeconds(0.9);
    QVERIFY(button->isEnabled());
    press(Qt::Key_H);
    QVERIFY(session().isRunning());
    QCOMPARE(session().take(), model::TakeId{0});
    QVERIFY(std::abs(transport().seconds() - 0.9) < 0.04);  // at a step
    QTRY_VERIFY(child<QSlider>("timeSlider")->isEnabled()); // there is something before it
    QTRY_VERIFY_WITH_TIMEOUT(session().takenShare() < 0.0, kPatienceMs);
    QVERIFY(std::abs(xAt(0.9) - begun) < 0.06F);
    QCOMPARE(xAt(0.3), early); // what was before can still be seen
    QCOMPARE(session().firstSeconds(), take.begin);
    transport().setSeconds(session().liveSeconds());
    transport().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(transport().seconds() > 3.0, kPatienceMs);
    transport().setPlaying(false);
    QVERIFY(xAt(3.0) < begun - 0.5F);
    // From a moment that the take has shown: a run out of a run.
    transport().setSeconds(0.3);
    press(Qt::Key_H);
    QTRY_VERIFY_WITH_TIMEOUT(session().takenShare() < 0.0, kPatienceMs);
    QVERIFY(std::abs(session().liveSeconds() - 0.3) < 0.04);
    QVERIFY(std::abs(xAt(0.3) - early) < 0.06F);
    QCOMPARE(session().firstSeconds(), take.begin);
    // All of it becomes a take, and undo shows the first one again.
    keep();
    QCOMPARE(takes().back().begin, take.begin);
    document().undoStack().undo();
    document().undoStack().undo();
    QCOMPARE(session().take(), take.id);
    QVERIFY(!session().isRunning());
    QCOMPARE(xAt(0.3), early);
    transport().setSeconds(0.6);
    button->click();
    QVERIFY(session().isRunning() && session().take() == 0);
}

void TestTakes::someActAgainAndOthersDoWhatTheyDid()
{
    play(3);
    keep();
    showPanel();
    auto* button = child<QToolButton>("retake");
    state().selection().set(
        std::vector<model::IndividualId>{document().scene().population.ids()[1]});
    QVERIFY(!button->isEnabled()); // of a take alone
    press(Qt::Key_N);
    QVERIFY(button->isEnabled());
    const float before = xAt(1.4, 1);
    const float other = xAt(1.4, 2);
    turnPath(); // who acts again goes the other way
    transport().setSeconds(0.4);
    const float begun = xAt(0.4, 1);
    QString said;
    connect(&state(), &widgets::EditorState::statusMessage, this,
            [&said](const QString& text) { said = text; });
    press(Qt::Key_J);
    QTRY_COMPARE_WITH_TIMEOUT(takes().size(), std::size_t{2}, kPatienceMs);
    QCOMPARE(session().take(), takes().back().id);
    QVERIFY2(said.contains(QStringLiteral("1 character")), qPrintable(said));
    QCOMPARE(xAt(0.4, 1), begun);
    QCOMPARE(xAt(1.4, 2), other);
    QVERIFY(xAt(1.4, 1) < before - 0.2F);
    document().undoStack().undo();
    QCOMPARE(session().take(), takes().front().id);
    QCOMPARE(xAt(1.4, 1), before);
    // At its end nothing is left of it: all of it, then.
    transport().setSeconds(takes().front().end);
    press(Qt::Key_J);
    QTRY_COMPARE_WITH_TIMEOUT(takes().size(), std::size_t{2}, kPatienceMs);
    document().undoStack().undo();
    // Nobody selected: it says whom it wants.
    state().selection().set({});
    press(Qt::Key_J);
    QVERIFY2(said.contains(QStringLiteral("Select")), qPrintable(said));
}

void TestTakes::theyArePaintedToDoSo()
{
    play(3, 2.0F);
    QString said;
    connect(&state(), &widgets::EditorState::statusMessage, this,
            [&said](const QString& text) { said = text; });
    const auto paint = [this](std::size_t row, bool isTakenBack = false) {
        widgets::ViewportWidget* view = &m_window->viewport();
        const QPoint at = pixelOf(row);
        QTest::mouseMove(view, at);
        QTest::mousePress(view, Qt::LeftButton, {}, at);
        QTest::mouseMove(view, at + QPoint(2, 0));
        if (isTakenBack) {
            QTest::keyClick(view, Qt::Key_Escape);
        }
        QTest::mouseRelease(view, Qt::LeftButton, {}, at + QPoint(2, 0));
    };
    QTest::keyClick(&m_window->viewport(), Qt::Key_A, Qt::ShiftModifier);
    QCOMPARE(state().tool(), widgets::ToolId::BrushRetake);
    model::BrushSettings brush = state().brush(model::BrushKind::Retake);
    brush.radiusPixels = 8.0F;
    state().setBrush(brush);
    transport().setSeconds(0.4);
    paint(1); // of a run nobody does anything again
    QVERIFY2(said.contains(QStringLiteral("No take is shown")), qPrintable(said));
    keep();
    press(Qt::Key_N);
    const float before = xAt(1.4, 1);
    const float other = xAt(1.4, 2);
    turnPath();
    const float begun = xAt(0.4, 1);
    paint(1, true);
    QVERIFY(state().selection().isEmpty());
    QVERIFY(state().takes().keptShare() < 0.0F);
    paint(1);
    QCOMPARE(state().selection().size(), std::size_t{1}); // one sees who it is
    QTRY_COMPARE_WITH_TIMEOUT(takes().size(), std::size_t{2}, kPatienceMs);
    QCOMPARE(xAt(0.4, 1), begun);
    QCOMPARE(xAt(1.4, 2), other);
    QVERIFY(xAt(1.4, 1) < before - 0.2F);
}

void TestTakes::twoAreComparedFromBeginningToEnd()
{
    play(3);
    keep();
    showPanel();
    auto* figures = child<QLabel>("takeFigures");
    press(Qt::Key_N);
    state().selection().set(
        std::vector<model::IndividualId>{document().scene().population.ids()[1]});
    turnPath();
    transport().setSeconds(0.4);
    press(Qt::Key_J);
    QTRY_COMPARE_WITH_TIMEOUT(takes().size(), std::size_t{2}, kPatienceMs);
    QVERIFY(!figures->isVisible());
    child<QListWidget>("takesList")->setCurrentRow(1); // what was there before
    child<QToolButton>("ghostTake")->click();
    const auto says = [figures](const char* text) {
        return figures->text().contains(QString::fromLatin1(text));
    };
    QTRY_VERIFY2_WITH_TIMEOUT(says("1 of 3"), qPrintable(figures->text()), kPatienceMs);
    QVERIFY(figures->isVisible());
    QVERIFY2(says("from 0:00 on"), qPrintable(figures->text()));
    // What is done by hand to the one that is shown counts.
    state().selection().selectAll();
    transport().setSeconds(0.2);
    child<QToolButton>("addHandEdit")->menu()->actions()[2]->trigger(); // still
    QTRY_VERIFY2_WITH_TIMEOUT(says("3 of 3"), qPrintable(figures->text()), kPatienceMs);
    child<QToolButton>("ghostTake")->click();
    QVERIFY(!figures->isVisible());
}

void TestTakes::peopleOfItAreEditedByHand()
{
    play(3);
    keep();
    showPanel();
    auto* list = child<QListWidget>("handEdits");
    auto* on = child<QCheckBox>("handEditsOn");
    QVERIFY(!on->isVisible()); // the scene as it plays is shown
    press(Qt::Key_N);
    QVERIFY(on->isVisible() && !list->isVisible());
    auto* add = child<QToolButton>("addHandEdit");
    QVERIFY(!add->isEnabled());
    const float before = xAt(1.4, 1);
    const float other = xAt(1.4, 2);
    state().selection().set(
        std::vector<model::IndividualId>{document().scene().population.ids()[1]});
    QVERIFY(add->isEnabled());
    transport().setSeconds(0.2);
    add->menu()->actions()[2]->trigger(); // still
    QCOMPARE(list->count(), 1);
    QVERIFY2(list->item(0)->text().contains(QStringLiteral("still, 0:00.2–0:02.2 (1)")),
             qPrintable(list->item(0)->text()));
    QVERIFY(xAt(1.4, 1) < before - 0.3F);
    QCOMPARE(xAt(1.4, 2), other);
    // Off and on again, by the mouse.
    const QRect row = list->visualItemRect(list->item(0));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, {row.left() + 10, row.center().y()});
    QTRY_VERIFY(!takes().front().edits.front().isOn);
    QCOMPARE(xAt(1.4, 1), before);
    document().undoStack().undo();
    QVERIFY(xAt(1.4, 1) < before - 0.3F);
    QCOMPARE(list->item(0)->checkState(), Qt::Checked);
    on->click();
    QCOMPARE(xAt(1.4, 1), before);
    on->click();
    // What it says is set in the form below.
    auto* form = child<QWidget>("handEditForm");
    QVERIFY(form->isVisible());
    QVERIFY(child<QDockWidget>("takes")->widget()->minimumSizeHint().width() <= 290);
    state().selection().set({});
    child<QToolButton>("selectEdited")->click();
    QCOMPARE(state().selection().ids().size(), std::size_t{1});
    child<QToolButton>("removeHandEdit")->click();
    QVERIFY(takes().front().edits.empty());
    QVERIFY(!form->isVisible());
    QCOMPARE(xAt(1.4, 1), before);
    // Every kind of it from the menu.
    for (QAction* action : add->menu()->actions()) {
        action->trigger();
    }
    QCOMPARE(takes().front().edits.size(), std::size_t{6});
    QCOMPARE(list->currentRow(), 5);
    QVERIFY(takes().front().edits.back().templates.empty()); // the scene has no other one
}

void TestTakes::oneOfThemIsSomebodyElse()
{
    play(2, 2.0F);
    document().edit(QStringLiteral("Import"), [this](model::SceneEdit& edit) {
        model::TemplateEntry woman = document().scene().templates.front();
        woman.id = 2;
        woman.name = "woman";
        edit.addTemplate(woman);
    });
    keep();
    showPanel();
    press(Qt::Key_N);
    state().selection().set(
        std::vector<model::IndividualId>{document().scene().population.ids()[1]});
    transport().setSeconds(0.6);
    child<QToolButton>("addHandEdit")->menu()->actions().back()->trigger();
    const auto* list = child<QListWidget>("handEdits");
    QVERIFY2(list->item(0)->text().contains(QStringLiteral("somebody else: woman")),
             qPrintable(list->item(0)->text()));
    const auto templateAt = [this](double seconds) {
        transport().setSeconds(seconds);
        return state().frame()->population.column(model::columns::templateId)[1];
    };
    QCOMPARE(templateAt(0.4), model::TemplateId{1});
    QCOMPARE(templateAt(0.8), model::TemplateId{2});
    QCOMPARE(document().scene().population.column(model::columns::templateId)[1],
             model::TemplateId{1}); // the scene keeps him
    // How the scene has him is how he is seen, whenever that is changed.
    const model::Tint red{200, 10, 10, 255};
    document().edit(QStringLiteral("Colour"), [this, &red](model::SceneEdit& edit) {
        const std::vector<model::IndividualId> whom{document().scene().population.ids()[1]};
        edit.setColumn(model::columns::tint(1), whom, std::span<const model::Tint>(&red, 1));
    });
    QVERIFY(state().frame()->population.column(model::columns::tint(1))[1] == red);
    // Of none, as a file may say, he is himself.
    model::Takes edited = takes();
    edited.front().edits.front().templates.clear();
    document().edit(QStringLiteral("Clear"),
                    [&edited](model::SceneEdit& edit) { edit.set<model::members::Takes>(edited); });
    QCOMPARE(templateAt(0.8), model::TemplateId{1});
    QVERIFY2(list->item(0)->text().contains(QStringLiteral("choose of which template")),
             qPrintable(list->item(0)->text()));
}

void TestTakes::editsSurviveARetakeAndAFile()
{
    play(3);
    keep();
    showPanel();
    press(Qt::Key_N);
    const auto ids = document().scene().population.ids();
    const std::vector<model::IndividualId> people(ids.begin(), ids.end());
    transport().setSeconds(0.1);
    state().selection().set(std::vector{people[2]});
    child<QToolButton>("addHandEdit")->menu()->actions()[3]->trigger(); // aside
    const auto edits = takes().front().edits;
    state().selection().set(std::vector{people[0]});
    turnPath();
    transport().setSeconds(0.4);
    press(Qt::Key_J);
    QTRY_COMPARE_WITH_TIMEOUT(takes().size(), std::size_t{2}, kPatienceMs);
    QVERIFY(takes().back().isShown);
    QVERIFY(takes().back().edits == edits);
    model::Scene copy = document().scene();
    document().undoStack().setClean();
    openScene(copy, QStringLiteral("edited.crowd"));
    QVERIFY(takes().back().motion && takes().back().edits == edits);
    QVERIFY(child<QListWidget>("handEdits")->count() == 1);
}

void TestTakes::thePanelShowsRenamesAndRemoves()
{
    play();
    showPanel();
    child<QToolButton>("keepTake")->click();
    QTRY_COMPARE_WITH_TIMEOUT(takes().size(), std::size_t{1}, kPatienceMs);
    auto* list = child<QListWidget>("takesList");
    QCOMPARE(list->count(), 2);
    list->scrollToItem(list->item(1));
    const QPoint row = list->visualItemRect(list->item(1)).center();
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, row);
    QTest::keyClick(list, Qt::Key_Return);
    QCOMPARE(session().take(), takes().front().id);
    QVERIFY(list->item(1)->font().bold() && !list->item(0)->font().bold());
    list->setFocus();
    QTest::keyClick(list, Qt::Key_F2);
    QLineEdit* field = nullptr;
    QTRY_VERIFY((field = list->findChild<QLineEdit*>()) != nullptr);
    QTest::keyClicks(field, QStringLiteral("Rehearsal"));
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_COMPARE(takes().front().name, std::string("Rehearsal"));
    QTRY_COMPARE(list->item(1)->text(), QStringLiteral("Rehearsal"));
    list->setFocus();
    list->setCurrentRow(1);
    QTest::keyClick(list, Qt::Key_Delete);
    QVERIFY(takes().empty());
    QCOMPARE(session().take(), model::TakeId{0});
    document().undoStack().undo();
    QCOMPARE(takes().size(), std::size_t{1});
    QCOMPARE(session().take(), takes().front().id);
}

void TestTakes::itIsThereAfterSavingAndOpening()
{
    play();
    const float there = xAt(1.0);
    transport().setSeconds(session().liveSeconds());
    keep();
    press(Qt::Key_N);
    model::Scene copy = document().scene(); // as it would be saved elsewhere
    document().undoStack().setClean();
    openScene(copy, QStringLiteral("other.crowd"));
    QVERIFY(QFileInfo::exists(pathOf(QStringLiteral("other.takes"))));
    QCOMPARE(session().take(), takes().front().id);
    QCOMPARE(xAt(1.0), there);
}

void TestTakes::oneWhoseFileIsGoneSaysSo()
{
    play();
    keep();
    press(Qt::Key_N);
    model::Scene copy = document().scene();
    document().undoStack().setClean();
    copy.takes.front().motion.reset();
    QVERIFY(QDir(pathOf(QStringLiteral("walk.takes"))).removeRecursively());
    openScene(copy, QStringLiteral("lost.crowd"));
    QCOMPARE(session().take(), model::TakeId{0});
    QVERIFY(session().takeProblem().contains(QStringLiteral("Take 1")));
    showPanel();
    QVERIFY(child<QLabel>("takesNote")->text().contains(QStringLiteral("Take 1")));
    QVERIFY(!child<QToolButton>("ghostTake")->isEnabled());
    // The scene plays as if it were not shown.
    transport().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(session().isRunning(), kPatienceMs);
}

CROWD_WINDOW_TEST(TestTakes)
#include "tst_Takes.moc"
