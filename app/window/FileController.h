// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>
#include <QtCore/QStringList>
#include <QtCore/QTimer>

#include "app/window/BackgroundTask.h"
#include "model/base/Result.h"
#include "model/scene/Scene.h"
#include "widgets/state/EditorState.h"

namespace crowd::app {

/// New, Open, Save, Save As, recent files, the question about unsaved changes, autosave and
/// recovery. The scene is replaced only when the new one is whole. Main thread only.
class FileController : public QObject
{
    Q_OBJECT

public:
    FileController(widgets::EditorState& state, QWidget* window);

    void newTheatre();
    void newGround();
    void open();
    void openPath(const QString& path);
    /// Both: false when it was not saved (cancelled, or it could not be written: said in a dialog).
    bool save();
    bool saveAs();
    /// Copies every foreign asset beside the scene file, points the scene at the copies and saves.
    bool collectAssets();
    /// Asks whether to save when there are unsaved changes; false: the artist wants to stay.
    [[nodiscard]] bool mayLeaveScene();
    /// The window closes for good: nothing to recover.
    void forgetRecovery();
    /// After a crash: offers what was kept of documents that were never saved.
    void offerUntitledRecovery();

    [[nodiscard]] QStringList recentFiles() const;
    void clearRecentFiles();
    void setAutosaveSeconds(int seconds); ///< 0: off
    [[nodiscard]] bool isBusy() const { return m_task.isRunning(); }

Q_SIGNALS:
    void recentFilesChanged();
    /// A scene stands in the window; entries without asset have their problem.
    void sceneOpened();

private:
    void load(const QString& file, const QString& documentPath, bool isRecovered);
    void showNew(model::Scene scene);
    void take(model::Scene scene, const QString& path, bool isRecovered);
    bool write(const QString& path);
    void remember(const QString& path);
    void autosave();
    void reportFailure(const QString& title, const std::string& message);
    [[nodiscard]] QString recoveryToUse(const QString& path);

    widgets::EditorState& m_state;
    QWidget* m_window;
    BackgroundTask m_task;
    QTimer m_autosave;
    const QUndoCommand* m_savedAt = nullptr; ///< top of the undo stack at the last autosave
    bool m_isRecovered = false; ///< shown from a recovery: unsaved, whatever the undo stack says
};

} // namespace crowd::app
