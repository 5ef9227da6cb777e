// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include <QtCore/QDir>
#include <QtCore/QFileInfo>
#include <QtCore/QMimeData>
#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtCore/QTemporaryDir>
#include <QtGui/QDropEvent>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QToolBar>

#include "app/window/MainWindow.h"
#include "model/document/SceneEdit.h"
#include "model/project/ProjectFile.h"
#include "tests/app/SceneWindow.h"

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
    void droppedModelBecomesATemplate();
    void panelsAreRememberedAndReset();
    void shortcutsAreRemembered();
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
    trigger("rewind");
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

void MainWindowTest::droppedModelBecomesATemplate()
{
    const QString man = QStringLiteral(CROWD_RESOURCES "/templates/man.glb");
    QVERIFY2(QFileInfo::exists(man), qPrintable(man));
    openScene(plainScene(0), QStringLiteral("a.crowd"));
    QSignalSpy added(&m_window->assets(), &app::AssetController::templateAdded);
    QMimeData files;
    files.setUrls({QUrl::fromLocalFile(man)});
    const DialogAnswer asTemplate(pressing(QStringLiteral("Template")));
    QDragEnterEvent enter({200, 200}, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(m_window.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({200, 200}, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(m_window.get(), &drop);
    QTRY_VERIFY_WITH_TIMEOUT(asTemplate.hasAnswered(), kPatienceMs);
    const DialogAnswer accept([](QDialog& dialog) { dialog.accept(); });
    QTRY_COMPARE_WITH_TIMEOUT(added.count(), 1, kPatienceMs);
    QVERIFY(accept.hasAnswered());
    QCOMPARE(document().scene().templates.size(), std::size_t{2});
    QVERIFY(document().scene().templates[1].asset != nullptr);
    QVERIFY(document().isModified());
    document().undoStack().undo();
    QCOMPARE(document().scene().templates.size(), std::size_t{1});
}

void MainWindowTest::panelsAreRememberedAndReset()
{
    std::set<QString> names;
    for (const QDockWidget* dock : m_window->docks()) {
        QVERIFY(!dock->objectName().isEmpty());
        QVERIFY(names.insert(dock->objectName()).second);
        QVERIFY(!dock->windowTitle().isEmpty());
    }
    QDockWidget* first = m_window->docks().front();
    const QString name = first->objectName();
    first->hide();
    QDockWidget* second = m_window->docks()[1];
    m_window->addDockWidget(Qt::RightDockWidgetArea, second);
    QVERIFY(m_window->close());
    openWindow();
    auto* hidden = m_window->findChild<QDockWidget*>(name);
    QVERIFY(hidden->isHidden());
    QCOMPARE(m_window->dockWidgetArea(m_window->docks()[1]), Qt::RightDockWidgetArea);
    m_window->resetLayout();
    QVERIFY(!hidden->isHidden());
    QCOMPARE(m_window->dockWidgetArea(m_window->docks()[1]), Qt::LeftDockWidgetArea);
}

void MainWindowTest::shortcutsAreRemembered()
{
    const QKeySequence keys(QStringLiteral("Ctrl+Alt+J"));
    m_window->actions().setShortcut("frame-all", keys);
    QVERIFY(m_window->close());
    openWindow();
    QCOMPARE(m_window->actions().action("frame-all")->shortcut(), keys);
    m_window->actions().resetShortcuts();
    QCOMPARE(m_window->actions().action("frame-all")->shortcut(), QKeySequence(Qt::Key_Home));
}

int main(int argc, char** argv)
{
    QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    MainWindowTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_MainWindow.moc"
