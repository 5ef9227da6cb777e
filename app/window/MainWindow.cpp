// SPDX-License-Identifier: MIT
#include "app/window/MainWindow.h"

#include <cmath>
#include <string>

#include <QtCore/QFileInfo>
#include <QtCore/QMimeData>
#include <QtGui/QCloseEvent>
#include <QtGui/QKeyEvent>
#include <QtGui/QShortcut>
#include <QtWidgets/QApplication>
#include <QtWidgets/QDialog>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QToolBar>

#include "app/console/ConsoleDock.h"
#include "app/console/ScriptGuard.h"
#include "app/window/FieldKeys.h"
#include "app/window/KeysDialog.h"
#include "app/window/LookMenu.h"
#include "app/window/MemoryRelease.h"
#include "app/window/ModalKeys.h"
#include "app/window/PreferencesDialog.h"
#include "app/window/ReadyNames.h"
#include "app/window/RecentFiles.h"
#include "app/window/StatusPanel.h"
#include "app/window/StepMenu.h"
#include "app/window/ViewMemory.h"
#include "app/window/WelcomeHint.h"
#include "app/window/WindowActions.h"
#include "app/window/WindowBars.h"
#include "widgets/commands/ViewCommands.h"
#include "widgets/dialogs/WelcomePage.h"
#include "widgets/docks/DockBase.h"
#include "widgets/docks/Docks.h"
#include "widgets/rules/RuleProblems.h"
#include "widgets/state/Cues.h"

namespace crowd::app {

namespace {

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
    : m_state(m_document), m_brushes(m_state, nullptr), m_actions(this), m_files(m_state, this),
      m_assets(m_state, this), m_pictures(m_state, this), m_movies(m_state, this),
      m_queue(m_files, m_assets, this), m_interpreter(m_state),
      m_painter(m_interpreter, m_state, nullptr), m_recorder(m_document),
      m_viewport(new widgets::ViewportWidget(m_state, this)), m_layout(*this),
      m_bookmarks(m_state, m_actions, this), m_states(m_state, m_actions, this),
      m_language([this] { return isFree(); }, this)
{
    setObjectName(QStringLiteral("mainWindow"));
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setCentralWidget(m_viewport);
    m_layout.addAll({m_state, m_interpreter, m_recorder, this});
    addWindowActions(*this);
    new widgets::CueKeys(m_state, this);
    auto* keys = new FieldKeys(*this, *m_viewport);
    connect(keys, &FieldKeys::typedAtNothing, this,
            [this] { m_state.showStatus(tr("This field cannot be changed now.")); });
    new ModalKeys(*this);
    m_viewport->tools().leaveShortcutsToWindow();
    // In the panels Tab goes from field to field.
    QAction* hidePanels = m_actions.action("hide-panels");
    hidePanels->setShortcutContext(Qt::WidgetShortcut);
    m_viewport->addAction(hidePanels);
    buildAround();
    connectParts();
    m_layout.restore();
    applyPreferences(Preferences::load());
    rememberView(m_state);
    refreshTitle();
    WelcomeHint::showOnce(m_viewport, m_state);
    m_viewport->setFocus();
}

MainWindow::~MainWindow()
{
    // While they are whole: hidden, a field that somebody types into tells its dialog so.
    for (QDialog* dialog : findChildren<QDialog*>()) {
        dialog->hide();
    }
    // Docks and viewport look at document and state: they go first.
    m_layout.forget();
    delete takeCentralWidget();
    const auto docks = findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly);
    qDeleteAll(docks);
}

ConsoleDock& MainWindow::console()
{
    return *m_layout.dock<ConsoleDock>(DockId::Console);
}

/// What speaks to the artist around the picture; the panels and the actions are there.
void MainWindow::buildAround()
{
    connectDocks();
    // Of the console, and gone with it.
    new ScriptGuard(m_interpreter, m_state, *this, console(), *m_actions.action("script-cancel"));
    buildStatusBar();
    buildMenus();
    fillToolBar(*addToolBar(tr("Tool Bar")), m_actions, m_state, *m_viewport);
}

/// In the language of now. The old panels go when the new ones know what those knew.
void MainWindow::renewAround()
{
    m_viewport->setFocus(); // what is being typed into a field is taken
    setUpdatesEnabled(false);
    setLocale(QLocale()); // numbers in fields
    const QByteArray places = m_layout.places();
    const std::vector<QDockWidget*> before =
        m_layout.replaceAll({m_state, m_interpreter, m_recorder, this});
    delete findChild<QToolBar*>(QStringLiteral("toolBar"), Qt::FindDirectChildrenOnly);
    setMenuBar(new QMenuBar(this));
    m_actions.renewTexts();
    buildAround();
    m_status->setStatistics(m_viewport->statistics());
    m_layout.putBack(places);
    for (std::size_t i = 0; i < before.size(); ++i) {
        auto* now = static_cast<widgets::DockBase*>(m_layout.docks()[i]);
        now->takeOver(*static_cast<widgets::DockBase*>(before[i]));
        delete before[i];
    }
    if (auto* hint = m_viewport->findChild<WelcomeHint*>()) {
        delete hint;
        WelcomeHint::showOnce(m_viewport, m_state);
    }
    refreshTitle();
    setUpdatesEnabled(true);
}

/// Of the picture, physical.
glm::ivec2 MainWindow::viewPixels() const
{
    const QSizeF pixels = QSizeF(m_viewport->size()) * m_viewport->devicePixelRatioF();
    return {static_cast<int>(std::lround(pixels.width())),
            static_cast<int>(std::lround(pixels.height()))};
}

void MainWindow::savePicture()
{
    m_pictures.save(viewPixels());
}

void MainWindow::makeMovie()
{
    m_movies.make(viewPixels());
}

bool MainWindow::isFree()
{
    return !m_document.isEditOpen() && !m_viewport->tools().isDragging() && !m_files.isBusy() &&
           !m_assets.isBusy() && !m_pictures.isBusy() && !m_movies.isBusy() && m_queue.isEmpty() &&
           !m_interpreter.isRunning() && m_state.longWork().total == 0 &&
           QApplication::activeModalWidget() == nullptr &&
           QApplication::activePopupWidget() == nullptr;
}

void MainWindow::connectDocks()
{
    connect(&console(), &ConsoleDock::readyToClose, this, &QWidget::close);
    for (const DockInfo& info : dockTable()) {
        if (info.action != nullptr) { // which stands as the panel does
            connect(m_layout.dock(info.id), &QDockWidget::visibilityChanged, this,
                    [this] { m_actions.refresh(widgets::ActionInput::Window); });
        }
    }
    auto* templates = m_layout.dock<widgets::TemplatesDock>(DockId::Templates);
    auto* scene = m_layout.dock<widgets::SceneDock>(DockId::Scene);
    connect(templates, &widgets::TemplatesDock::importRequested, &m_assets,
            &AssetController::importTemplate);
    connect(templates, &widgets::TemplatesDock::libraryRequested, &m_assets,
            &AssetController::addFromLibrary);
    connect(templates, &widgets::TemplatesDock::locateRequested, &m_assets,
            &AssetController::locateTemplate);
    connect(templates, &widgets::TemplatesDock::clipsRequested, &m_assets,
            &AssetController::editClips);
    connect(templates, &widgets::TemplatesDock::removeRequested, &m_assets,
            &AssetController::removeTemplate);
    connect(scene, &widgets::SceneDock::importStageRequested, &m_assets,
            &AssetController::importStage);
    connect(scene, &widgets::SceneDock::locateStageRequested, &m_assets,
            &AssetController::locateStage);
    connect(scene, &widgets::SceneDock::importTemplateRequested, &m_assets,
            &AssetController::importTemplate);
    connect(scene, &widgets::SceneDock::locateTemplateRequested, &m_assets,
            &AssetController::locateTemplate);
    connect(scene, &widgets::SceneDock::removeTemplateRequested, &m_assets,
            &AssetController::removeTemplate);
}

void MainWindow::buildStatusBar()
{
    m_status = new StatusPanel(m_state, this);
    setStatusBar(m_status);
    connect(m_viewport, &widgets::ViewportWidget::statisticsChanged, m_status,
            &StatusPanel::setStatistics);
}

void MainWindow::buildMenus()
{
    const Submenus submenus = fillMenuBar(*menuBar(), m_actions, m_layout.docks());
    m_recentMenu = submenus.at("@recent");
    connect(m_recentMenu, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
    fillRecentMenu();
    fillExamplesMenu(submenus.at("@examples"));
    m_bookmarks.attach(submenus.at("@cameras"), submenus.at("@keep-cameras"));
    m_states.attach(submenus.at("@states"), submenus.at("@keep-states"));
    fillLookMenu(*submenus.at("@looks"), m_state);
    fillStepMenu(*submenus.at("@step-length"), m_state);
    fillLanguageMenu(*submenus.at("@language"),
                     [this](const QString& code) { chooseLanguage(code); });
}

void MainWindow::connectParts()
{
    connect(m_viewport, &widgets::ViewportWidget::problemChanged, this,
            [this](const QString& problem) {
                if (!problem.isEmpty()) {
                    m_state.showStatus(problem);
                }
            });
    connect(&m_files, &FileController::sceneOpened, &m_assets, &AssetController::reportMissing);
    connect(&m_files, &FileController::sceneOpened, this, &MainWindow::refreshTitle);
    connect(&m_files, &FileController::sceneOpened, new MemoryRelease(m_state.keyframes(), this),
            &MemoryRelease::plan);
    connect(&m_document, &model::SceneDocument::pathChanged, this, &MainWindow::refreshTitle);
    connect(&m_movies, &MovieController::ended, m_status, &StatusPanel::showUntilBack);
    connect(&m_state, &widgets::EditorState::toolChanged, &m_layout, &DockLayout::showToolSettings);
    connect(&m_document, &model::SceneDocument::modifiedChanged, this, &MainWindow::refreshTitle);
    connect(&m_document, &model::SceneDocument::undoRefused, this, [this](const QString& why) {
        m_document.isEditOpen() ? m_state.showStatus(why) : warn(tr("Undo"), why);
    });
    connect(&m_document, &model::SceneDocument::editRefused, &m_state,
            &widgets::EditorState::showStatus);
    connect(&m_document, &model::SceneDocument::undoMemoryExceeded, this,
            [this](const QString& why) { warn(tr("Undo"), why); });
    m_recorder.setProof([this](const model::StepCommitted& step) {
        return m_state.strokes().comesToTheSame(step);
    });
    connect(&m_recorder, &Recorder::remarked, &m_state, &widgets::EditorState::showStatus);
    connect(&m_state.session(), &widgets::SessionControl::posesKept, this, [this](int people) {
        m_state.showStatus(tr("%n characters are kept where they are", nullptr, people));
    });
    connect(&m_state.session(), &widgets::SessionControl::problemsChanged, this, [this] {
        const std::vector<behavior::Problem>& problems = m_state.session().problems();
        if (!problems.empty()) {
            m_state.showStatus(widgets::problemText(m_document.scene(), problems.back()));
        }
    });
    connect(&m_layout, &DockLayout::hiddenChanged, this, &MainWindow::followHiding);
    connect(&m_language, &LanguageSwitch::delayed, this, [this] {
        m_state.showStatus(tr("The language changes when what is going on has ended."));
    });
}

void MainWindow::followHiding(bool isHidden)
{
    m_viewport->setFocus(); // the key that brings the panels back is the picture's
    if (!isHidden) {
        m_status->clearMessage(); // they are back
        return;
    }
    m_state.showStatus(
        tr("%1 brings the panels back.")
            .arg(m_actions.action("hide-panels")->shortcut().toString(QKeySequence::NativeText)));
}

void MainWindow::warn(const QString& title, const QString& message)
{
    auto* box = new QMessageBox(QMessageBox::Warning, title, message, QMessageBox::Ok, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void MainWindow::refreshTitle()
{
    setWindowFilePath(m_document.path());
    setWindowTitle(tr("%1[*] – Crowdbrush").arg(m_files.documentName()));
    setWindowModified(m_document.isModified());
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

void MainWindow::fillExamplesMenu(QMenu* menu)
{
    for (const QString& path : FileController::examples()) {
        connect(menu->addAction(exampleName(path)), &QAction::triggered, &m_files,
                [this, path] { m_files.openPath(path); });
    }
    menu->setEnabled(!menu->isEmpty());
}

void MainWindow::applyPreferences(const Preferences& preferences)
{
    widgets::applyTheme(preferences.theme);
    m_files.setAutosaveSeconds(preferences.autosaveSeconds);
    m_state.keyframes().setBudget(static_cast<std::size_t>(preferences.keyframeMegabytes) << 20U);
    m_document.setUndoBudget(static_cast<std::size_t>(preferences.undoMegabytes) << 20U);
    m_state.undoGroups().setOn(preferences.groupsStrokes);
    auto options = m_state.viewOptions();
    options.buttons = preferences.buttons;
    options.quality = preferences.quality;
    options.samples = preferences.samples;
    m_state.setViewOptions(options);
    m_viewport->renewPicture(); // a larger budget lets more people move
}

void MainWindow::showPreferences()
{
    auto* dialog = new PreferencesDialog(m_actions, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &PreferencesDialog::changed, this, &MainWindow::applyPreferences);
    connect(dialog, &PreferencesDialog::languageChosen, this, &MainWindow::chooseLanguage);
    dialog->open();
}

void MainWindow::start(const QStringList& files)
{
    if (!files.isEmpty() || !Preferences::load().showsWelcome) {
        m_queue.openAtStart(files);
        return;
    }
    if (m_files.offerRecovery()) {
        return;
    }
    constexpr auto kOnceAndLater =
        static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection);
    connect(&m_files, &FileController::becameIdle, this, &MainWindow::showWelcome, kOnceAndLater);
    m_files.newTheatre();
}

/// Nothing is chosen on it that could not be chosen in the menu; it only comes by itself.
void MainWindow::showWelcome()
{
    if (auto* shown = findChild<widgets::WelcomePage*>()) {
        shown->raise();
        return;
    }
    auto* page = new widgets::WelcomePage(
        {FileController::examples(), recentFiles(), Preferences::load().showsWelcome}, this);
    page->setAttribute(Qt::WA_DeleteOnClose);
    page->addAction(m_actions.action("keys")); // the hint below it names that key
    connect(page, &widgets::WelcomePage::newTheatreChosen, &m_files, &FileController::newTheatre);
    connect(page, &widgets::WelcomePage::newGroundChosen, &m_files, &FileController::newGround);
    connect(page, &widgets::WelcomePage::openChosen, &m_files, &FileController::open);
    connect(page, &widgets::WelcomePage::libraryChosen, &m_assets,
            &AssetController::addFromLibrary);
    connect(page, &widgets::WelcomePage::sceneChosen, &m_files, &FileController::openPath);
    connect(page, &widgets::WelcomePage::showAtStartChanged, this, [](bool isShown) {
        Preferences changed = Preferences::load();
        changed.showsWelcome = isShown;
        changed.save();
    });
    page->open();
}

void MainWindow::showShortcuts()
{
    QWidget* above = QApplication::activeModalWidget();
    auto* dialog =
        new KeysDialog(m_actions, m_state.viewOptions().buttons, above != nullptr ? above : this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::showAbout()
{
    auto* box =
        new QMessageBox(QMessageBox::NoIcon, tr("About Crowdbrush"), {}, QMessageBox::Ok, this);
    box->setText(
        tr("<h3>Crowdbrush %1</h3><p>Paint crowds.</p>").arg(QApplication::applicationVersion()));
    box->setInformativeText(
        tr("<p>After “Crowdbrush: Interactive Authoring of Real-time Crowd Scenes” by Branislav "
           "Ulicny, Pablo de Heras Ciechomski and Daniel Thalmann, SCA 2004.</p><p>MIT licence. "
           "Made with Qt %1, GLM, Embree, tinygltf, meshoptimizer and oneTBB.</p>")
            .arg(QLatin1String(qVersion())));
    box->setIconPixmap(windowIcon().pixmap(64, 64));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (m_document.isEditOpen()) {
        m_viewport->tools().cancel();
    }
    if (!console().mayClose()) {
        event->ignore();
        return;
    }
    if (!m_files.mayLeaveScene()) {
        event->ignore();
        return;
    }
    m_files.forgetRecovery();
    m_layout.save();
    m_brushes.save();
    event->accept();
}

/// Shortcuts go to the active window alone, and for a while after a dialog has closed the window
/// may have the keyboard without being the active one: keys that nobody took are looked up here.
void MainWindow::keyPressEvent(QKeyEvent* event)
{
    QAction* action = event->isAutoRepeat()
                          ? nullptr
                          : m_actions.actionWithShortcut(QKeySequence(event->keyCombination()));
    if (action != nullptr && action->isEnabled()) {
        action->trigger();
        return;
    }
    const QKeySequence keys(event->keyCombination());
    for (QShortcut* cue : findChildren<QShortcut*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (!event->isAutoRepeat() && cue->isEnabled() && cue->key() == keys) {
            Q_EMIT cue->activated();
            return;
        }
    }
    QMainWindow::keyPressEvent(event);
}

void MainWindow::changeEvent(QEvent* event)
{
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::WindowStateChange) {
        m_actions.refresh(widgets::ActionInput::Window);
    } else if (event->type() == QEvent::LanguageChange) {
        renewAround();
    }
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
