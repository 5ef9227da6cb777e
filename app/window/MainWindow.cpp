// SPDX-License-Identifier: MIT
#include "app/window/MainWindow.h"

#include <algorithm>

#include <QtCore/QFileInfo>
#include <QtCore/QMimeData>
#include <QtCore/QSettings>
#include <QtGui/QCloseEvent>
#include <QtWidgets/QApplication>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QToolBar>

#include "app/window/KeysDialog.h"
#include "app/window/PreferencesDialog.h"
#include "app/window/RecentFiles.h"
#include "app/window/StatusPanel.h"
#include "app/window/WindowActions.h"
#include "widgets/docks/Docks.h"
#include "widgets/viewport/ViewCommands.h"

namespace crowd::app {

namespace {

const QString kGeometryKey = QStringLiteral("window/geometry");
const QString kLayoutKey = QStringLiteral("window/layout");
/// Grows when docks change so much that an old layout makes no sense.
constexpr int kLayoutVersion = 1;
constexpr int kToolIconSize = 22;

QStringList localFiles(const QMimeData* data)
{
    QStringList files;
    for (const QUrl& url : data->urls()) {
        if (url.isLocalFile()) {
            files << url.toLocalFile();
        }
    }
    return files;
}

} // namespace

MainWindow::MainWindow()
    : m_state(m_document), m_actions(this), m_files(m_state, this), m_assets(m_state, this),
      m_queue(m_files, m_assets, this), m_viewport(new widgets::ViewportWidget(m_state, this)),
      m_status(new StatusPanel(m_state, this))
{
    setObjectName(QStringLiteral("mainWindow"));
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setCentralWidget(m_viewport);
    setStatusBar(m_status);
    addDocks();
    addWindowActions(*this);
    buildMenus();
    buildToolBar();
    connectParts();
    restoreLayout();
    applySettings();
    refreshActions();
    refreshTitle();
    m_viewport->setFocus();
}

MainWindow::~MainWindow()
{
    // Docks and viewport look at document and state: they go first.
    m_docks.clear();
    delete takeCentralWidget();
    const auto docks = findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly);
    qDeleteAll(docks);
}

void MainWindow::addDock(QDockWidget* dock, Qt::DockWidgetArea area)
{
    addDockWidget(area, dock);
    m_docks.push_back(dock);
}

void MainWindow::addDocks()
{
    auto* templates = new widgets::TemplatesDock(m_state, this);
    auto* scene = new widgets::SceneDock(m_state, this);
    auto* individual = new widgets::IndividualDock(m_state, this);
    auto* history = new widgets::HistoryDock(m_state, this);
    addDock(new widgets::BrushPaletteDock(m_state, this), Qt::LeftDockWidgetArea);
    addDock(new widgets::BrushSettingsDock(m_state, this), Qt::LeftDockWidgetArea);
    addDock(templates, Qt::RightDockWidgetArea);
    addDock(new widgets::ColourDock(m_state, this), Qt::RightDockWidgetArea);
    addDock(individual, Qt::RightDockWidgetArea);
    addDock(scene, Qt::RightDockWidgetArea);
    addDock(history, Qt::RightDockWidgetArea);
    tabifyDockWidget(individual, scene);
    tabifyDockWidget(scene, history);
    individual->raise();
    connect(templates, &widgets::TemplatesDock::importRequested, &m_assets,
            &AssetController::importTemplate);
    connect(templates, &widgets::TemplatesDock::locateRequested, &m_assets,
            &AssetController::locateTemplate);
    connect(templates, &widgets::TemplatesDock::removeRequested, &m_assets,
            &AssetController::removeTemplate);
    connect(scene, &widgets::SceneDock::importStageRequested, &m_assets,
            &AssetController::importStage);
    connect(scene, &widgets::SceneDock::locateStageRequested, &m_assets,
            &AssetController::locateStage);
}

void MainWindow::buildMenus()
{
    for (const MenuSpec& spec : menuTable()) {
        QMenu* menu = menuBar()->addMenu(QCoreApplication::translate("Menus", spec.title));
        for (const std::string id : spec.ids) {
            if (id.empty()) {
                menu->addSeparator();
            } else if (id == "@recent") {
                m_recentMenu = menu->addMenu(tr("Open &Recent"));
            } else if (id == "@cameras") {
                m_cameraMenu = menu->addMenu(tr("Go to &Camera"));
            } else if (id == "@docks") {
                for (QDockWidget* dock : m_docks) {
                    menu->addAction(dock->toggleViewAction());
                }
            } else {
                menu->addAction(m_actions.action(id));
            }
        }
    }
    connect(m_recentMenu, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
    connect(m_cameraMenu, &QMenu::aboutToShow, this, &MainWindow::fillCameraMenu);
    fillRecentMenu();
    fillCameraMenu();
}

void MainWindow::buildToolBar()
{
    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("toolBar"));
    bar->setIconSize({kToolIconSize, kToolIconSize});
    for (const std::string id : toolBarTable()) {
        if (id.empty()) {
            bar->addSeparator();
        } else {
            bar->addAction(m_actions.action(id));
        }
    }
}

void MainWindow::connectParts()
{
    connect(m_viewport, &widgets::ViewportWidget::statisticsChanged, m_status,
            &StatusPanel::setStatistics);
    connect(m_viewport, &widgets::ViewportWidget::problemChanged, this,
            [this](const QString& problem) {
                if (!problem.isEmpty()) {
                    m_state.showStatus(problem);
                }
            });
    connect(&m_files, &FileController::sceneOpened, &m_assets, &AssetController::reportMissing);
    connect(&m_document, &model::SceneDocument::pathChanged, this, &MainWindow::refreshTitle);
    connect(&m_document, &model::SceneDocument::modifiedChanged, this, &MainWindow::refreshTitle);
    connect(&m_document, &model::SceneDocument::undoRefused, this, [this](const QString& why) {
        m_document.isEditOpen() ? m_state.showStatus(why) : warn(tr("Undo"), why);
    });
    connect(&m_document, &model::SceneDocument::undoMemoryExceeded, this,
            [this](const QString& why) { warn(tr("Undo"), why); });
    const auto refresh = [this] { refreshActions(); };
    connect(&m_document.undoStack(), &QUndoStack::indexChanged, this, refresh);
    connect(&m_state, &widgets::EditorState::toolChanged, this, refresh);
    connect(&m_state, &widgets::EditorState::brushChanged, this, refresh);
    connect(&m_state, &widgets::EditorState::viewOptionsChanged, this, refresh);
    connect(&m_state.selection(), &widgets::Selection::changed, this, refresh);
    connect(&m_state.transport(), &widgets::Transport::stateChanged, this, refresh);
}

void MainWindow::warn(const QString& title, const QString& message)
{
    auto* box = new QMessageBox(QMessageBox::Warning, title, message, QMessageBox::Ok, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void MainWindow::refreshTitle()
{
    const QString path = m_document.path();
    const QString name = path.isEmpty() ? tr("Untitled") : QFileInfo(path).fileName();
    setWindowFilePath(path);
    setWindowTitle(tr("%1[*] – Crowdbrush").arg(name));
    setWindowModified(m_document.isModified());
}

void MainWindow::refreshActions()
{
    const auto check = [this](const char* id, bool on) { m_actions.action(id)->setChecked(on); };
    const QUndoStack& stack = m_document.undoStack();
    m_actions.action("undo")->setEnabled(stack.canUndo());
    m_actions.action("redo")->setEnabled(stack.canRedo());
    m_actions.action("undo")->setText(stack.canUndo() ? tr("&Undo %1").arg(stack.undoText())
                                                      : tr("&Undo"));
    m_actions.action("redo")->setText(stack.canRedo() ? tr("&Redo %1").arg(stack.redoText())
                                                      : tr("&Redo"));
    for (const widgets::ToolInfo& info : widgets::toolTable()) {
        check(info.stableId, info.id == m_state.tool());
    }
    for (const char* id : {"brush-larger", "brush-smaller"}) {
        m_actions.action(id)->setEnabled(m_state.activeBrush() != nullptr);
    }
    const bool hasSelection = !m_state.selection().isEmpty();
    m_actions.action("delete")->setEnabled(hasSelection);
    m_actions.action("select-none")->setEnabled(hasSelection);
    check("seat-grid", m_state.isSeatGridOn());
    check("ground-grid", m_state.viewOptions().showGroundGrid);
    check("shadows", m_state.viewOptions().showShadows);
    check("look-lit", m_state.viewOptions().look == render::Look::Lit);
    const bool isPlaying = m_state.transport().isPlaying();
    check("play", isPlaying);
    check("full-screen", isFullScreen());
}

void MainWindow::fillRecentMenu()
{
    m_recentMenu->clear();
    m_recentMenu->setToolTipsVisible(true);
    const QStringList recent = recentFiles();
    for (const QString& path : recent) {
        const QFileInfo file(path);
        const auto sameName = std::ranges::count_if(recent, [&file](const QString& other) {
            return QFileInfo(other).fileName() == file.fileName();
        });
        QString text =
            sameName > 1 ? tr("%1 in %2").arg(file.fileName(), file.path()) : file.fileName();
        QAction* action =
            m_recentMenu->addAction(text.replace(QLatin1Char('&'), QStringLiteral("&&")));
        action->setToolTip(path);
        action->setStatusTip(path);
        connect(action, &QAction::triggered, &m_files, [this, path] { m_files.openPath(path); });
    }
    if (m_recentMenu->isEmpty()) {
        m_recentMenu->addAction(tr("No scenes yet"))->setEnabled(false);
        return;
    }
    m_recentMenu->addSeparator();
    connect(m_recentMenu->addAction(tr("&Clear This List")), &QAction::triggered, this,
            [] { clearRecentFiles(); });
}

void MainWindow::fillCameraMenu()
{
    m_cameraMenu->clear();
    for (const model::NamedCamera& camera : m_state.scene().cameras) {
        const QString name = QString::fromStdString(camera.name);
        connect(m_cameraMenu->addAction(name), &QAction::triggered, this,
                [this, name] { widgets::goToCamera(m_state, name); });
    }
    if (m_cameraMenu->isEmpty()) {
        m_cameraMenu->addAction(tr("The scene has no cameras"))->setEnabled(false);
    }
}

void MainWindow::restoreLayout()
{
    resize(1280, 800);
    resizeDocks({m_docks[1]}, {280}, Qt::Horizontal);
    resizeDocks({m_docks[2], m_docks[3], m_docks[4]}, {220, 260, 260}, Qt::Vertical);
    m_initialLayout = saveState(kLayoutVersion);
    const QSettings settings;
    if (settings.contains(kGeometryKey)) {
        restoreGeometry(settings.value(kGeometryKey).toByteArray());
    }
    restoreState(settings.value(kLayoutKey).toByteArray(), kLayoutVersion);
}

void MainWindow::resetLayout()
{
    restoreState(m_initialLayout, kLayoutVersion);
    for (QDockWidget* dock : m_docks) {
        dock->show();
    }
}

void MainWindow::setTheme(widgets::Theme theme)
{
    widgets::applyTheme(theme);
    m_actions.refreshIcons();
}

void MainWindow::applySettings()
{
    const Preferences preferences = Preferences::load();
    setTheme(preferences.theme);
    m_files.setAutosaveSeconds(preferences.autosaveSeconds);
    auto options = m_state.viewOptions();
    options.buttons = preferences.buttons;
    m_state.setViewOptions(options);
}

void MainWindow::showPreferences()
{
    auto* dialog = new PreferencesDialog(m_actions, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, &MainWindow::applySettings);
    dialog->open();
}

void MainWindow::showShortcuts()
{
    auto* dialog = new KeysDialog(m_actions, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::showAbout()
{
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, tr("About Crowdbrush"),
        tr("<h3>Crowdbrush %1</h3><p>An editor that paints crowds.</p><p>After “Crowdbrush: "
           "Interactive Authoring of Real-time Crowd Scenes”, Ulicny, de Heras Ciechomski and "
           "Thalmann, 2004.</p>")
            .arg(QApplication::applicationVersion()),
        QMessageBox::Ok, this);
    box->setIconPixmap(windowIcon().pixmap(64, 64));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (m_document.isEditOpen()) {
        m_viewport->tools().cancel();
    }
    if (!m_files.mayLeaveScene()) {
        event->ignore();
        return;
    }
    m_files.forgetRecovery();
    QSettings settings;
    settings.setValue(kGeometryKey, saveGeometry());
    settings.setValue(kLayoutKey, saveState(kLayoutVersion));
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!localFiles(event->mimeData()).isEmpty()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event)
{
    event->acceptProposedAction();
    const QStringList files = localFiles(event->mimeData());
    // The drop must end before a dialog may open.
    QMetaObject::invokeMethod(
        this, [this, files] { m_queue.drop(files); }, Qt::QueuedConnection);
}

} // namespace crowd::app
