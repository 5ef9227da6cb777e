// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include <QtCore/QFileInfo>
#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtCore/QTemporaryDir>
#include <QtCore/QTimer>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QKeySequenceEdit>
#include <QtWidgets/QLabel>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QStatusBar>
#include <QtWidgets/QStyle>
#include <QtWidgets/QTableWidget>
#include <QtWidgets/QToolBar>

#include "app/window/MainWindow.h"
#include "app/window/PreferencesDialog.h"
#include "app/window/RecentFiles.h"
#include "app/window/ShortcutsPage.h"
#include "app/window/StatusPanel.h"
#include "model/document/SceneEdit.h"
#include "model/project/ProjectFile.h"
#include "model/states/StateKeeping.h"
#include "tests/app/SceneWindow.h"
#include "tests/program/WindowTest.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

/// Every action in a menu and the menus below it.
void collectActions(const QMenu& menu, std::set<const QAction*>& found)
{
    for (const QAction* action : menu.actions()) {
        found.insert(action);
        if (action->menu() != nullptr) {
            collectActions(*action->menu(), found);
        }
    }
}

} // namespace

/// The editor's real window: files, questions, recovery, import, panels, actions.
class MainWindowTest : public QObject, private SceneWindow
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { prepare("MainWindowTest"); }
    void init() { begin(); }
    void cleanup() { m_window.reset(); }

    void everyActionIsComplete();
    void everyActionCanBeReached();
    void noTwoActionsShareKeys();
    void harmlessActionsDoWhatTheySay();
    void undoActionFollowsTheDocument();
    void titleTellsOfChanges();
    void keysThatAreNoShortcutsYetStillAct();
    void shownTagsAreRemembered();
    void twoScenesInARowDoNotCollide();
    void examplesOpenAsNewScenes();
    void panelsAreRememberedAndReset();
    void pictureOnlyHidesThePanelsAndBringsThemBack();
    void numberKeysKeepAndShowCameras();
    void theLassoIsOfTheToolInHand();
    void functionKeysKeepAndRecallStates();
    void recentFilesComeNewestFirst();
    void shortcutsAreRemembered();
    void changedShortcutFreesItsOldKeys();
    void shortcutConflictsAreNamed();
    void preferencesTakeEffectAndCanBeTakenBack();
    void memoryForUndoIsAPreference();
    void statusBarCounts();
    void statusBarCountsWhoIsThere();
    void aRemarkGoesWithItsTool();
    void aRemarkGoesWithItsScene();
    void whatTookLongIsSaidUntilSomebodyIsBack();
    void controlSpacePlaysOverThePicture();
    void iconsFollowTheTheme();
};

void MainWindowTest::everyActionIsComplete()
{
    QVERIFY(m_window->actions().specs().size() > 30);
    for (const widgets::ActionSpec& spec : m_window->actions().specs()) {
        const QAction* action = m_window->actions().action(spec.id);
        QVERIFY2(!action->text().isEmpty(), spec.id);
        QVERIFY2(!action->icon().isNull(), spec.id);
        QVERIFY2(!action->icon().pixmap(24, 24).isNull(), spec.id);
        QVERIFY2(!action->toolTip().isEmpty() && !action->statusTip().isEmpty(), spec.id);
        QVERIFY2(!action->shortcuts().isEmpty(), spec.id);
        QVERIFY2(action->isCheckable() == spec.isCheckable, spec.id);
    }
}

void MainWindowTest::everyActionCanBeReached()
{
    model::Scene scene = plainScene(0);
    for (const char* name : {"b", "c", "d", "e", "f", "g", "h", "i"}) {
        scene.cameras.push_back({name, scene.cameras.front().camera});
    }
    for (model::StateId id = 1; id <= 9; ++id) {
        scene.states.push_back(
            model::keepState(scene, "state " + std::to_string(id), model::usualStateColumns(), {}));
        scene.states.back().id = id;
    }
    openScene(scene, QStringLiteral("a.crowd"));
    for (QMenu* menu : m_window->findChildren<QMenu*>()) {
        Q_EMIT menu->aboutToShow(); // some are filled then
    }
    std::set<const QAction*> reached;
    for (const QAction* top : m_window->menuBar()->actions()) {
        QVERIFY(top->menu() != nullptr);
        collectActions(*top->menu(), reached);
    }
    for (const widgets::ActionSpec& spec : m_window->actions().specs()) {
        QVERIFY2(reached.contains(m_window->actions().action(spec.id)), spec.id);
    }
}

void MainWindowTest::noTwoActionsShareKeys()
{
    std::map<QString, std::string> owners;
    for (const widgets::ActionSpec& spec : m_window->actions().specs()) {
        for (const QKeySequence& keys : m_window->actions().action(spec.id)->shortcuts()) {
            const auto [at, isNew] = owners.emplace(keys.toString(), spec.id);
            QVERIFY2(isNew,
                     (at->second + " and " + spec.id + " share " + keys.toString().toStdString())
                         .c_str());
        }
    }
}

void MainWindowTest::harmlessActionsDoWhatTheySay()
{
    openScene(plainScene(5), QStringLiteral("a.crowd"));
    auto& state = m_window->state();
    const auto trigger = [this](const char* id) { m_window->actions().action(id)->trigger(); };
    for (const widgets::ToolInfo& info : widgets::toolTable()) {
        trigger(info.stableId);
        QCOMPARE(state.tool(), info.id);
        QVERIFY(m_window->actions().action(info.stableId)->isChecked());
    }
    trigger("select-all");
    QCOMPARE(state.selection().size(), std::size_t{5});
    trigger("select-invert");
    QVERIFY(state.selection().isEmpty());
    trigger("select-invert");
    trigger("delete");
    QCOMPARE(document().scene().population.size(), std::size_t{0});
    trigger("undo");
    QCOMPARE(document().scene().population.size(), std::size_t{5});
    trigger("redo");
    QCOMPARE(document().scene().population.size(), std::size_t{0});
    const bool seats = state.isSeatGridOn();
    trigger("seat-grid");
    QCOMPARE(state.isSeatGridOn(), !seats);
    const bool grid = state.viewOptions().showGroundGrid;
    trigger("ground-grid");
    QCOMPARE(state.viewOptions().showGroundGrid, !grid);
    const bool isPlaying = state.transport().isPlaying();
    trigger("play");
    QCOMPARE(state.transport().isPlaying(), !isPlaying);
    trigger("stop");
    QVERIFY(!state.transport().isPlaying());
    const std::size_t cameras = document().scene().cameras.size();
    trigger("camera-add");
    QCOMPARE(document().scene().cameras.size(), cameras + 1);
    state.setTool(widgets::ToolId::BrushCreate);
    const float radius = state.activeBrush()->radiusPixels;
    trigger("brush-larger");
    QVERIFY(state.activeBrush()->radiusPixels > radius);
    trigger("brush-smaller");
    trigger("brush-smaller");
    QVERIFY(state.activeBrush()->radiusPixels < radius);
    for (const char* id : {"frame-all", "frame-selection", "view-front", "view-side", "view-top",
                           "projection", "shadows", "look-lit"}) {
        trigger(id); // nothing of these may crash; what they do to the view is tested elsewhere
    }
    document().undoStack().setClean();
}

void MainWindowTest::undoActionFollowsTheDocument()
{
    openScene(plainScene(3), QStringLiteral("a.crowd"));
    const QAction* undo = m_window->actions().action("undo");
    const QAction* redo = m_window->actions().action("redo");
    QVERIFY(!undo->isEnabled() && !redo->isEnabled());
    moveEverybody(document(), 4.0F);
    QVERIFY(undo->isEnabled());
    QVERIFY2(undo->text().contains(QStringLiteral("Move")), qPrintable(undo->text()));
    document().undoStack().undo();
    QVERIFY(!undo->isEnabled() && redo->isEnabled());
}

void MainWindowTest::titleTellsOfChanges()
{
    openScene(plainScene(2), QStringLiteral("party.crowd"));
    QVERIFY(m_window->windowTitle().contains(QStringLiteral("party.crowd")));
    QVERIFY(!m_window->isWindowModified());
    moveEverybody(document(), 1.0F);
    QVERIFY(m_window->isWindowModified());
    document().undoStack().undo();
    QVERIFY(!m_window->isWindowModified());
}

void MainWindowTest::panelsAreRememberedAndReset()
{
    std::set<QString> names;
    for (const QDockWidget* dock : m_window->docks()) {
        QVERIFY(!dock->objectName().isEmpty());
        QVERIFY(names.insert(dock->objectName()).second);
        QVERIFY(!dock->windowTitle().isEmpty());
    }
    QDockWidget* first = m_window->dockLayout().dock(app::DockId::Brushes);
    const QString name = first->objectName();
    first->hide();
    QDockWidget* second = m_window->dockLayout().dock(app::DockId::BrushSettings);
    m_window->addDockWidget(Qt::RightDockWidgetArea, second);
    QVERIFY(m_window->close());
    openWindow();
    auto* hidden = m_window->findChild<QDockWidget*>(name);
    QVERIFY(hidden->isHidden());
    QCOMPARE(m_window->dockWidgetArea(m_window->dockLayout().dock(app::DockId::BrushSettings)),
             Qt::RightDockWidgetArea);
    m_window->dockLayout().reset();
    QVERIFY(!hidden->isHidden());
    QCOMPARE(m_window->dockWidgetArea(m_window->dockLayout().dock(app::DockId::BrushSettings)),
             Qt::LeftDockWidgetArea);
}

void MainWindowTest::keysThatAreNoShortcutsYetStillAct()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    const bool wasOn = m_window->state().viewOptions().showGroundGrid;
    QKeyEvent press(QEvent::KeyPress, Qt::Key_G, Qt::ControlModifier); // past the shortcuts
    QApplication::sendEvent(&m_window->viewport(), &press);
    QCOMPARE(m_window->state().viewOptions().showGroundGrid, !wasOn);
    // In the middle of a stroke they mean nothing.
    const QPoint at = m_window->viewport().rect().center();
    QTest::mousePress(&m_window->viewport(), Qt::LeftButton, {}, at);
    QKeyEvent again(QEvent::KeyPress, Qt::Key_G, Qt::ControlModifier);
    QApplication::sendEvent(&m_window->viewport(), &again);
    QTest::mouseRelease(&m_window->viewport(), Qt::LeftButton, {}, at);
    QCOMPARE(m_window->state().viewOptions().showGroundGrid, !wasOn);
}

void MainWindowTest::recentFilesComeNewestFirst()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    openScene(plainScene(1), QStringLiteral("b.crowd"));
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    const QStringList recent = app::recentFiles();
    QCOMPARE(recent.size(), 2);
    QCOMPARE(QFileInfo(recent[0]).fileName(), QStringLiteral("a.crowd"));
    app::clearRecentFiles();
    QVERIFY(app::recentFiles().isEmpty());
}

void MainWindowTest::shortcutsAreRemembered()
{
    const QKeySequence keys(QStringLiteral("Ctrl+Alt+J"));
    m_window->actions().setShortcut("frame-all", keys);
    QVERIFY(m_window->close());
    openWindow();
    QCOMPARE(m_window->actions().action("frame-all")->shortcut(), keys);
    app::PreferencesDialog dialog(m_window->actions(), m_window.get());
    pressing(QStringLiteral("All Back to Defaults"))(dialog);
    dialog.shortcuts().apply();
    QCOMPARE(m_window->actions().action("frame-all")->shortcut(), QKeySequence(Qt::Key_Home));
}

void MainWindowTest::shownTagsAreRemembered()
{
    QVERIFY(!m_window->state().viewOptions().showTags);
    m_window->actions().action("tags")->trigger();
    QVERIFY(m_window->state().viewOptions().showTags);
    openWindow();
    QVERIFY(m_window->state().viewOptions().showTags);
    QVERIFY(m_window->actions().action("tags")->isChecked());
    m_window->actions().action("tags")->trigger();
    openWindow();
    QVERIFY(!m_window->state().viewOptions().showTags);
}

void MainWindowTest::twoScenesInARowDoNotCollide()
{
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->actions().action("new-theatre")->trigger();
    m_window->actions().action("new-ground")->trigger(); // the first is still being read
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
    QVERIFY(!m_window->files().isBusy());
    QCOMPARE(document().scene().stages.size(), std::size_t{1});
}

void MainWindowTest::examplesOpenAsNewScenes()
{
    const QStringList examples = app::FileController::examples();
    QVERIFY(!examples.isEmpty());
    QVERIFY(examples.front().endsWith(QStringLiteral("theatre.crowd")));
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->files().openPath(examples.front());
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 3 * kPatienceMs);
    QVERIFY(document().scene().population.size() >= 500);
    QVERIFY2(document().path().isEmpty(), "saving must not write into the program's own files");
    QVERIFY(m_window->windowTitle().startsWith(QStringLiteral("Theatre")));
    QVERIFY(app::recentFiles().isEmpty());
}

void MainWindowTest::pictureOnlyHidesThePanelsAndBringsThemBack()
{
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    QDockWidget* closed = m_window->dockLayout().dock(app::DockId::Brushes);
    closed->hide();
    m_window->viewport().setFocus();
    QTest::keyClick(&m_window->viewport(), Qt::Key_Tab);
    QVERIFY(m_window->dockLayout().isHidden());
    for (const QDockWidget* dock : m_window->docks()) {
        QVERIFY(dock->isHidden());
    }
    QTRY_COMPARE(m_window->viewport().width(), m_window->width());
    QTest::keyClick(&m_window->viewport(), Qt::Key_Tab);
    QVERIFY(!m_window->dockLayout().isHidden());
    QVERIFY2(closed->isHidden(), "what was closed before stays closed");
    QVERIFY(!m_window->dockLayout().dock(app::DockId::BrushSettings)->isHidden());
    m_window->actions().action("hide-panels")->trigger();
    QVERIFY(m_window->close());
    openWindow();
    QVERIFY2(!m_window->dockLayout().dock(app::DockId::BrushSettings)->isHidden(),
             "the next start has its panels");
}

void MainWindowTest::theLassoIsOfTheToolInHand()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    auto& state = m_window->state();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_window->viewport().setFocus();
    const QAction* action = m_window->actions().action("select-lasso");
    const auto selection = [&state] { return state.brush(model::BrushKind::Colour).selection; };
    state.setTool(widgets::ToolId::BrushColour);
    QVERIFY(selection() != model::BrushSelection::Lasso);
    QTest::keyClick(&m_window->viewport(), Qt::Key_L);
    QCOMPARE(selection(), model::BrushSelection::Lasso);
    QVERIFY(action->isChecked());
    QVERIFY(!state.viewOptions().selectsByLasso);
    state.setTool(widgets::ToolId::Select);
    QVERIFY(!action->isChecked());
    QTest::keyClick(&m_window->viewport(), Qt::Key_L);
    QVERIFY(state.viewOptions().selectsByLasso && action->isChecked());
    QTest::keyClick(&m_window->viewport(), Qt::Key_L);
    QVERIFY(!state.viewOptions().selectsByLasso);
    state.setTool(widgets::ToolId::BrushColour);
    QVERIFY(action->isChecked());
    QTest::keyClick(&m_window->viewport(), Qt::Key_L);
    QCOMPARE(selection(), model::BrushSelection::AllInCircle);
}

void MainWindowTest::numberKeysKeepAndShowCameras()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    auto& state = m_window->state();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    const model::Camera first = state.camera();
    const model::Camera other = model::Camera::lookingAt({20.0F, 9.0F, 3.0F}, {0.0F, 1.0F, 0.0F});
    state.setCamera(other);
    QTest::keyClick(&m_window->viewport(), Qt::Key_5, Qt::ControlModifier);
    QCOMPARE(document().scene().cameras.size(), std::size_t{2}); // the next free number
    QVERIFY(document().scene().cameras[1].camera == other);
    QTest::keyClick(&m_window->viewport(), Qt::Key_1);
    QVERIFY(state.cameraTarget() == first);
    QTRY_VERIFY(state.camera() == state.cameraTarget());
    QTest::keyClick(&m_window->viewport(), Qt::Key_2);
    QVERIFY(state.cameraTarget() == other);
    QTRY_VERIFY(state.camera() == state.cameraTarget());
    QTest::keyClick(&m_window->viewport(), Qt::Key_7); // nothing there: says so, moves nothing
    QVERIFY(state.cameraTarget() == other);
    QTest::keyClick(&m_window->viewport(), Qt::Key_1, Qt::ControlModifier);
    QVERIFY(document().scene().cameras[0].camera == other);
    document().undoStack().undo();
    QVERIFY(document().scene().cameras[0].camera == first);
    document().undoStack().setClean();
}

void MainWindowTest::functionKeysKeepAndRecallStates()
{
    openScene(plainScene(2), QStringLiteral("a.crowd"));
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    const auto ids = document().scene().population.ids();
    const auto setPhase = [&](float phase) {
        document().edit(QStringLiteral("Phase"), [&](model::SceneEdit& edit) {
            edit.setColumn(model::columns::phase, ids, std::span<const float>(&phase, 1));
        });
    };
    const auto phase = [this] {
        return document().scene().population.column(model::columns::phase)[0];
    };
    m_window->state().transport().setPlaying(false);
    QTest::keyClick(&m_window->viewport(), Qt::Key_F1, Qt::ShiftModifier);
    QVERIFY(m_window->statusBar()->currentMessage().contains(QStringLiteral("no state 1")));
    for (const float each : {0.25F, 0.5F}) {
        setPhase(each);
        QTest::keyClick(&m_window->viewport(), Qt::Key_F9,
                        Qt::ControlModifier | Qt::ShiftModifier); // the next free number
    }
    QCOMPARE(document().scene().states.size(), std::size_t{2});
    QTest::keyClick(&m_window->viewport(), Qt::Key_F1, Qt::ShiftModifier);
    QCOMPARE(phase(), 0.25F);
    setPhase(0.75F);
    QTest::keyClick(&m_window->viewport(), Qt::Key_F2, Qt::ControlModifier | Qt::ShiftModifier);
    QTest::keyClick(&m_window->viewport(), Qt::Key_F1, Qt::ShiftModifier);
    QTest::keyClick(&m_window->viewport(), Qt::Key_F2, Qt::ShiftModifier);
    QCOMPARE(phase(), 0.75F);
    document().undoStack().undo();
    QCOMPARE(phase(), 0.25F);
    // While it plays: in the run alone.
    const int steps = document().undoStack().index();
    m_window->state().transport().setPlaying(true);
    QTest::keyClick(&m_window->viewport(), Qt::Key_F2, Qt::ShiftModifier);
    QTRY_COMPARE(m_window->state().frame()->population.column(model::columns::phase)[0], 0.75F);
    QCOMPARE(phase(), 0.25F);
    QCOMPARE(document().undoStack().index(), steps);
    m_window->state().session().stop();
    QCOMPARE(m_window->state().frame()->population.column(model::columns::phase)[0], 0.25F);
    document().undoStack().setClean();
}

void MainWindowTest::changedShortcutFreesItsOldKeys()
{
    openScene(plainScene(3), QStringLiteral("a.crowd"));
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_window->viewport().setFocus();
    m_window->state().setTool(widgets::ToolId::Select);
    m_window->actions().setShortcut("brush-colour", QKeySequence(QStringLiteral("Y")));
    QTest::keyClick(&m_window->viewport(), Qt::Key_B);
    QCOMPARE(m_window->state().tool(), widgets::ToolId::Select);
    QTest::keyClick(&m_window->viewport(), Qt::Key_Y);
    QCOMPARE(m_window->state().tool(), widgets::ToolId::BrushColour);
}

void MainWindowTest::shortcutConflictsAreNamed()
{
    app::PreferencesDialog dialog(m_window->actions(), m_window.get());
    app::ShortcutsPage& page = dialog.shortcuts();
    const auto keysOf = [this](const char* id) {
        return m_window->actions().action(id)->shortcut();
    };
    const auto* said = page.findChild<QLabel*>(QString(), Qt::FindDirectChildrenOnly);
    const QString before = said->text();
    const QKeySequence create = keysOf("brush-create");
    const auto* table = page.findChild<QTableWidget*>();
    const auto* open = table->findItems(QStringLiteral("Open…"), Qt::MatchExactly).value(0);
    QVERIFY(open != nullptr);
    auto* keys = qobject_cast<QKeySequenceEdit*>(table->cellWidget(open->row(), 1));
    keys->setKeySequence(create);
    Q_EMIT keys->editingFinished();
    QVERIFY2(said->text().contains(QStringLiteral("Create")), qPrintable(said->text()));
    QCOMPARE(keysOf("open"), QKeySequence(QStringLiteral("Ctrl+O")));
    pressing(QStringLiteral("Give It to “Open…”"))(dialog);
    QCOMPARE(said->text(), before);
    QCOMPARE(keysOf("brush-create"), create); // not before the dialog is accepted
    page.apply();
    QCOMPARE(keysOf("open"), create);
    QVERIFY(keysOf("brush-create").isEmpty());
    pressing(QStringLiteral("All Back to Defaults"))(dialog);
    page.apply();
    QCOMPARE(keysOf("brush-create"), create);
}

void MainWindowTest::preferencesTakeEffectAndCanBeTakenBack()
{
    m_window->showPreferences();
    auto* dialog = m_window->findChild<app::PreferencesDialog*>();
    QVERIFY(dialog != nullptr);
    const std::size_t before = m_window->state().keyframes().progress().budgetBytes;
    app::Preferences wanted = app::Preferences::load();
    wanted.keyframeMegabytes = 777;
    wanted.buttons = widgets::ButtonMapping::Paper;
    wanted.quality = widgets::PictureQuality::Best;
    wanted.samples = 2;
    Q_EMIT dialog->changed(wanted);
    QCOMPARE(m_window->state().keyframes().progress().budgetBytes, std::size_t{777} << 20U);
    QCOMPARE(m_window->state().viewOptions().buttons, widgets::ButtonMapping::Paper);
    QCOMPARE(m_window->state().viewOptions().quality, widgets::PictureQuality::Best);
    QCOMPARE(m_window->state().viewOptions().samples, 2);
    for (auto* box : dialog->findChildren<QSpinBox*>()) {
        box->setValue(box->value() + 64); // the memory
    }
    dialog->reject();
    QCOMPARE(m_window->state().keyframes().progress().budgetBytes, before);
    QCOMPARE(m_window->state().viewOptions().buttons, widgets::ButtonMapping::Standard);
    QCOMPARE(m_window->state().viewOptions().quality, widgets::PictureQuality::Fast); // as tests do
    QCOMPARE(m_window->state().viewOptions().samples, 4);
    wanted.samples = 8;
    wanted.save();
    QCOMPARE(app::Preferences::load().samples, 8);
    wanted.samples = 3; // by hand
    wanted.save();
    QCOMPARE(app::Preferences::load().samples, 4);
}

void MainWindowTest::memoryForUndoIsAPreference()
{
    openScene(plainScene(2000), QStringLiteral("a.crowd"));
    const std::vector<model::IndividualId> ids(document().scene().population.ids().begin(),
                                               document().scene().population.ids().end());
    for (const float radians : {1.0F, 2.0F}) {
        const auto edit = document().beginEdit().value();
        edit->setColumn(model::columns::heading, ids, std::span<const float>(&radians, 1));
        QVERIFY(edit->commit(QStringLiteral("Turn")));
    }
    QCOMPARE(document().undoMemory().bytesOnDisk(), std::uint64_t{0});
    m_window->showPreferences();
    auto* dialog = m_window->findChild<app::PreferencesDialog*>();
    app::Preferences wanted = app::Preferences::load();
    QCOMPARE(wanted.undoMegabytes, 256);
    wanted.undoMegabytes = 0;
    wanted.groupsStrokes = true;
    Q_EMIT dialog->changed(wanted);
    QVERIFY(document().undoMemory().bytesOnDisk() > 0);
    QVERIFY(m_window->state().undoGroups().isOn());
    for (auto* box : dialog->findChildren<QCheckBox*>()) {
        box->setChecked(box->isChecked() || box->text().contains(QStringLiteral("short strokes")));
    }
    for (auto* box : dialog->findChildren<QSpinBox*>()) {
        if (box->toolTip().contains(QStringLiteral("temporary file"))) {
            box->setValue(32);
        }
    }
    dialog->accept();
    QCOMPARE(app::Preferences::load().undoMegabytes, 32);
    QVERIFY(app::Preferences::load().groupsStrokes);
    document().undoStack().clear();
    document().undoStack().setClean();
}

void MainWindowTest::statusBarCounts()
{
    openScene(plainScene(5), QStringLiteral("a.crowd"));
    m_window->state().selection().set(document().scene().population.ids().first(1));
    const auto* counts = m_window->findChild<QLabel*>(QStringLiteral("statusCounts"));
    QTRY_COMPARE_WITH_TIMEOUT(counts->text(),
                              QStringLiteral("5 characters · 5 in view · 1 selected"), kPatienceMs);
    const auto* frame = m_window->findChild<QLabel*>(QStringLiteral("statusFrame"));
    QTRY_VERIFY_WITH_TIMEOUT(frame->text().contains(QStringLiteral(" ms")), kPatienceMs);
}

void MainWindowTest::statusBarCountsWhoIsThere()
{
    model::Scene scene = plainScene(3);
    scene.places = {{1, "near", {0.0F, 0.0F, 0.5F}, 0.5F}, {2, "out", {0.0F, 0.0F, 2.5F}, 1.0F}};
    scene.places[1].role = model::PlaceRole::Exit;
    scene.paths = {{1, "away", model::PathKind::Simple, {1, 2}}};
    const auto first = scene.population.ids().front();
    scene.population.setValues<model::PathId>(model::columns::path, std::span(&first, 1),
                                              std::vector<model::PathId>{1});
    openScene(scene, QStringLiteral("a.crowd"));
    const auto* counts = m_window->findChild<QLabel*>(QStringLiteral("statusCounts"));
    m_window->state().transport().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(counts->text().startsWith(QStringLiteral("2 characters · 1 ")),
                             4 * kPatienceMs);
    m_window->state().session().stop();
    QTRY_VERIFY_WITH_TIMEOUT(counts->text().startsWith(QStringLiteral("3 characters ·")),
                             kPatienceMs);
    QVERIFY(!counts->text().contains(QStringLiteral("left")));
}

void MainWindowTest::aRemarkGoesWithItsTool()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    m_window->state().setTool(widgets::ToolId::BrushCreate);
    m_window->state().showStatus(QStringLiteral("85 characters created"));
    QCOMPARE(m_window->statusBar()->currentMessage(), QStringLiteral("85 characters created"));
    m_window->state().setTool(widgets::ToolId::BrushWalk);
    QVERIFY(m_window->statusBar()->currentMessage().isEmpty());
}

void MainWindowTest::aRemarkGoesWithItsScene()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    m_window->state().showStatus(QStringLiteral("Undone: Paint"));
    openScene(plainScene(2), QStringLiteral("b.crowd"));
    QVERIFY(!m_window->statusBar()->currentMessage().contains(QStringLiteral("Undone")));
}

/// Whoever went away meanwhile reads it.
void MainWindowTest::whatTookLongIsSaidUntilSomebodyIsBack()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    auto* bar = m_window->findChild<app::StatusPanel*>();
    QVERIFY(bar != nullptr);
    bar->showUntilBack(QStringLiteral("Made walk.mp4"));
    const auto willGo = [bar] {
        const auto timers = bar->findChildren<QTimer*>();
        return std::ranges::any_of(timers, &QTimer::isActive);
    };
    QVERIFY(!willGo());
    QTest::keyClick(m_window->windowHandle(), Qt::Key_Shift);
    QCOMPARE(bar->currentMessage(), QStringLiteral("Made walk.mp4")); // to be read
    QVERIFY(willGo());
}

void MainWindowTest::controlSpacePlaysOverThePicture()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_window->viewport().setFocus();
    const auto& transport = m_window->state().transport();
    const bool wasPlaying = transport.isPlaying();
    QTest::keyClick(m_window->windowHandle(), Qt::Key_Space, Qt::ControlModifier);
    QCOMPARE(transport.isPlaying(), !wasPlaying);
    QTest::keyClick(m_window->windowHandle(), Qt::Key_Space, Qt::ControlModifier);
    QCOMPARE(transport.isPlaying(), wasPlaying);
}

void MainWindowTest::iconsFollowTheTheme()
{
    const auto average = [this] {
        const QImage picture = m_window->actions().action("open")->icon().pixmap(32, 32).toImage();
        int sum = 0;
        int drawn = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                if (const QColor color = picture.pixelColor(x, y); color.alpha() > 200) {
                    sum += color.lightness();
                    ++drawn;
                }
            }
        }
        return drawn == 0 ? -1 : sum / drawn;
    };
    widgets::applyTheme(widgets::Theme::Light);
    QVERIFY(average() < 100);
    widgets::applyTheme(widgets::Theme::Dark);
    QVERIFY(average() > 150);
    widgets::applyTheme(widgets::Theme::Light);
    QVERIFY(average() < 100);
    const QStyle* style = QApplication::style();
    widgets::applyTheme(widgets::Theme::Light); // as it is: nothing is polished anew
    QCOMPARE(QApplication::style(), style);
}

CROWD_WINDOW_TEST(MainWindowTest)

#include "tst_MainWindow.moc"
