// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QMainWindow>

#include "app/console/Interpreter.h"
#include "app/console/StrokePainter.h"
#include "app/record/Recorder.h"
#include "app/window/AssetController.h"
#include "app/window/BrushMemory.h"
#include "app/window/CameraBookmarks.h"
#include "app/window/DockLayout.h"
#include "app/window/FileController.h"
#include "app/window/FileQueue.h"
#include "app/window/LanguageMenu.h"
#include "app/window/MovieController.h"
#include "app/window/PictureController.h"
#include "app/window/StateKeys.h"
#include "model/document/SceneDocument.h"
#include "widgets/actions/ActionRegistry.h"
#include "widgets/state/EditorState.h"
#include "widgets/viewport/ViewportWidget.h"

class QMenu;

namespace crowd::app {

class ConsoleDock;
class StatusPanel;
struct Preferences;

/// The editor's window: puts document, state, viewport, docks, actions and controllers together and
/// connects them; what they do is their own affair. In another language menus, tool bar, panels and
/// status bar are made anew around what is edited, which stays, and so does the picture.
class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    MainWindow();
    ~MainWindow() override;

    [[nodiscard]] model::SceneDocument& document() { return m_document; }
    [[nodiscard]] widgets::EditorState& state() { return m_state; }
    [[nodiscard]] widgets::ActionRegistry& actions() { return m_actions; }
    [[nodiscard]] widgets::ViewportWidget& viewport() { return *m_viewport; }
    [[nodiscard]] FileController& files() { return m_files; }
    [[nodiscard]] AssetController& assets() { return m_assets; }
    [[nodiscard]] FileQueue& queue() { return m_queue; }
    [[nodiscard]] BrushMemory& brushes() { return m_brushes; }
    [[nodiscard]] Interpreter& interpreter() { return m_interpreter; }
    [[nodiscard]] Recorder& recorder() { return m_recorder; }
    [[nodiscard]] ConsoleDock& console();
    [[nodiscard]] DockLayout& dockLayout() { return m_layout; }
    /// As the program starts: with these files, or with the welcome page over an empty theatre.
    void start(const QStringList& files);
    [[nodiscard]] const std::vector<QDockWidget*>& docks() const { return m_layout.docks(); }

    /// Nothing is in the middle of being done: no stroke, no dialog, no script, no file.
    [[nodiscard]] bool isFree();
    void chooseLanguage(const QString& code) { m_language.choose(code); }
    void showPreferences();
    void savePicture();
    void makeMovie();
    void showWelcome();
    void showShortcuts();
    void showAbout();

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    [[nodiscard]] glm::ivec2 viewPixels() const;
    void buildAround();
    void renewAround();
    void connectDocks();
    void buildStatusBar();
    void buildMenus();
    void connectParts();
    void warn(const QString& title, const QString& message);
    void followHiding(bool isHidden);
    void refreshTitle();
    void fillRecentMenu();
    void fillExamplesMenu(QMenu* menu);
    void applyPreferences(const Preferences& preferences);

    model::SceneDocument m_document;
    widgets::EditorState m_state;
    BrushMemory m_brushes;
    widgets::ActionRegistry m_actions;
    FileController m_files;
    AssetController m_assets;
    PictureController m_pictures;
    MovieController m_movies;
    FileQueue m_queue;
    Interpreter m_interpreter;
    StrokePainter m_painter;
    Recorder m_recorder;
    widgets::ViewportWidget* m_viewport; ///< child
    StatusPanel* m_status = nullptr;     ///< child
    QMenu* m_recentMenu = nullptr;       ///< child
    DockLayout m_layout;
    CameraBookmarks m_bookmarks;
    StateKeys m_states;
    LanguageSwitch m_language;
};

} // namespace crowd::app
