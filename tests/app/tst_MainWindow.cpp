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
#include "model/project/Autosave.h"
#include "model/project/ProjectFile.h"
#include "tests/app/WindowTools.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

constexpr int kPatienceMs = 10'000;

/// Men on empty ground.
model::Scene plainScene(std::size_t people)
{
    model::Scene scene;
    scene.name = "plain";
    scene.cameras.push_back(
        {"front", model::Camera::lookingAt({0.0F, 6.0F, 12.0F}, {0.0F, 0.0F, 0.0F})});
    model::TemplateEntry man;
    man.id = 1;
    man.name = "man";
    man.path = "builtin:templates/man.glb";
    man.clipNames = {"idle"};
    scene.templates.push_back(man);
    std::vector<model::IndividualId> ids;
    for (std::size_t i = 0; i < people; ++i) {
        ids.push_back(scene.nextId++);
    }
    model::IndividualRows rows = model::IndividualRows::withDefaults(ids);
    std::ranges::fill(rows.column(model::columns::templateId), man.id);
    scene.population.add(rows);
    return scene;
}

void moveEverybody(model::SceneDocument& document, float x)
{
    const auto present = document.scene().population.ids();
    const std::vector<model::IndividualId> ids(present.begin(), present.end());
    const glm::vec3 place(x, 0.0F, 0.0F);
    const auto edit = document.beginEdit();
    edit->setColumn(model::columns::position, ids, std::span<const glm::vec3>(&place, 1));
    edit->commit(QStringLiteral("Move"));
}

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
class MainWindowTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();

    void everyActionIsComplete();
    void everyActionCanBeReached();
    void noTwoActionsShareKeys();
    void harmlessActionsDoWhatTheySay();
    void undoActionFollowsTheDocument();
    void savesAndReopensIdentically();
    void titleTellsOfChanges();
    void asksBeforeClosing();
    void unreadableFileLeavesTheSceneAlone();
    void missingAssetsAreNamed();
    void offersRecoveryAfterACrash();
    void declinedRecoveryIsGone();
    void autosavesOnItsTimer();
    void droppedModelBecomesATemplate();
    void panelsAreRememberedAndReset();
    void recentFilesComeNewestFirst();
    void shortcutsAreRemembered();

private:
    void openWindow();
    void openScene(const model::Scene& scene, const QString& name);
    [[nodiscard]] QString pathOf(const QString& name) const { return m_folder->filePath(name); }
    [[nodiscard]] model::SceneDocument& document() const { return m_window->document(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<app::MainWindow> m_window;
};

void MainWindowTest::initTestCase()
{
    QCoreApplication::setOrganizationName(QStringLiteral("CrowdbrushTest"));
    QCoreApplication::setApplicationName(QStringLiteral("MainWindowTest"));
    QStandardPaths::setTestModeEnabled(true);
    qputenv("CROWDBRUSH_RESOURCES", CROWD_RESOURCES);
}

void MainWindowTest::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder->path());
    QSettings().clear();
    openWindow();
}

void MainWindowTest::cleanup()
{
    m_window.reset();
}

void MainWindowTest::openWindow()
{
    m_window = std::make_unique<app::MainWindow>();
    m_window->resize(1100, 720);
    m_window->state().transport().setPlaying(false);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
}

void MainWindowTest::openScene(const model::Scene& scene, const QString& name)
{
    QVERIFY(model::saveProject(scene, pathOf(name)).isOk());
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->files().openPath(pathOf(name));
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
}

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

void MainWindowTest::savesAndReopensIdentically()
{
    openScene(plainScene(40), QStringLiteral("a.crowd"));
    moveEverybody(document(), 7.25F);
    QVERIFY(m_window->files().save());
    QVERIFY(!document().isModified());
    QFile file(pathOf(QStringLiteral("a.crowd")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray saved = file.readAll();
    const model::Population before = document().scene().population;
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->files().openPath(pathOf(QStringLiteral("a.crowd")));
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
    QVERIFY(document().scene().population == before);
    QVERIFY(m_window->files().save());
    file.close();
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), saved);
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

void MainWindowTest::asksBeforeClosing()
{
    openScene(plainScene(2), QStringLiteral("a.crowd"));
    moveEverybody(document(), 3.0F);
    {
        const DialogAnswer cancel(pressing(QMessageBox::Cancel));
        QVERIFY(!m_window->close());
        QVERIFY(cancel.hasAnswered());
        QVERIFY(m_window->isVisible());
    }
    {
        const DialogAnswer save(pressing(QMessageBox::Save));
        QVERIFY(m_window->close());
        QVERIFY(save.hasAnswered());
    }
    const auto saved = model::readProject(pathOf(QStringLiteral("a.crowd")));
    QVERIFY(saved.isOk());
    QCOMPARE(saved.value().population.column(model::columns::position)[0].x, 3.0F);
}

void MainWindowTest::unreadableFileLeavesTheSceneAlone()
{
    openScene(plainScene(6), QStringLiteral("a.crowd"));
    QFile broken(pathOf(QStringLiteral("broken.crowd")));
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("not a scene");
    broken.close();
    QString message;
    const DialogAnswer answer([&message](QDialog& dialog) {
        if (auto* box = qobject_cast<QMessageBox*>(&dialog)) {
            message = box->text();
        }
        dialog.accept();
    });
    m_window->files().openPath(broken.fileName());
    QTRY_VERIFY_WITH_TIMEOUT(answer.hasAnswered(), kPatienceMs);
    QVERIFY2(message.contains(QStringLiteral("broken.crowd")), qPrintable(message));
    QCOMPARE(document().scene().population.size(), std::size_t{6});
    QCOMPARE(QFileInfo(document().path()).fileName(), QStringLiteral("a.crowd"));
}

void MainWindowTest::missingAssetsAreNamed()
{
    model::Scene scene = plainScene(1);
    model::TemplateEntry lost;
    lost.id = 2;
    lost.name = "dragon";
    lost.path = pathOf(QStringLiteral("dragon.glb")).toStdString();
    lost.clipNames = {"fly"};
    scene.templates.push_back(lost);
    QString message;
    const DialogAnswer answer([&message](QDialog& dialog) {
        if (auto* box = qobject_cast<QMessageBox*>(&dialog)) {
            message = box->text();
        }
        dialog.accept();
    });
    openScene(scene, QStringLiteral("a.crowd"));
    QTRY_VERIFY_WITH_TIMEOUT(answer.hasAnswered(), kPatienceMs);
    QVERIFY2(message.contains(QStringLiteral("dragon")), qPrintable(message));
    QVERIFY(m_window->files().save());
    const auto saved = model::readProject(pathOf(QStringLiteral("a.crowd")));
    QVERIFY(saved.isOk());
    QCOMPARE(saved.value().templates.size(), std::size_t{2});
    QCOMPARE(saved.value().templates[1].clipNames, lost.clipNames);
}

void MainWindowTest::offersRecoveryAfterACrash()
{
    const QString path = pathOf(QStringLiteral("a.crowd"));
    QVERIFY(model::saveProject(plainScene(2), path).isOk());
    QVERIFY(model::writeAutosave(plainScene(9), path).isOk());
    const DialogAnswer yes(pressing(QMessageBox::Yes));
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->files().openPath(path);
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
    QVERIFY(yes.hasAnswered());
    QCOMPARE(document().scene().population.size(), std::size_t{9});
    QCOMPARE(document().path(), path);
    QVERIFY2(document().isModified(), "what was recovered is not what the file holds");
    QVERIFY(m_window->files().save());
    QVERIFY(model::findRecovery(path).isEmpty());
    QCOMPARE(model::readProject(path).value().population.size(), std::size_t{9});
}

void MainWindowTest::declinedRecoveryIsGone()
{
    const QString path = pathOf(QStringLiteral("a.crowd"));
    QVERIFY(model::saveProject(plainScene(2), path).isOk());
    QVERIFY(model::writeAutosave(plainScene(9), path).isOk());
    const DialogAnswer no(pressing(QMessageBox::No));
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->files().openPath(path);
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
    QVERIFY(no.hasAnswered());
    QCOMPARE(document().scene().population.size(), std::size_t{2});
    QVERIFY(model::findRecovery(path).isEmpty());
}

void MainWindowTest::autosavesOnItsTimer()
{
    openScene(plainScene(2), QStringLiteral("a.crowd"));
    const QString path = document().path();
    m_window->files().setAutosaveSeconds(1);
    moveEverybody(document(), 5.0F);
    QTRY_VERIFY_WITH_TIMEOUT(!model::findRecovery(path).isEmpty(), 5000);
    QVERIFY(document().isModified());
    QVERIFY(m_window->files().save());
    QVERIFY2(model::findRecovery(path).isEmpty(), "a clean save leaves nothing to recover");
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

void MainWindowTest::recentFilesComeNewestFirst()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    openScene(plainScene(1), QStringLiteral("b.crowd"));
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    const QStringList recent = m_window->files().recentFiles();
    QCOMPARE(recent.size(), 2);
    QCOMPARE(QFileInfo(recent[0]).fileName(), QStringLiteral("a.crowd"));
    m_window->files().clearRecentFiles();
    QVERIFY(m_window->files().recentFiles().isEmpty());
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
