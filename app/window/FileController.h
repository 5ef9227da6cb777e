// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QtCore/QDateTime>
#include <QtCore/QObject>
#include <QtCore/QStringList>

#include "app/window/Autosaver.h"
#include "app/window/DialogTask.h"
#include "model/base/Result.h"
#include "model/scene/Scene.h"
#include "widgets/state/EditorState.h"

namespace crowd::app {

/// New, Open, Save, Save As, the question about unsaved changes, recovery after a crash. The scene
/// is replaced only when the new one is whole. Main thread only.
class FileController : public QObject
{
    Q_OBJECT

public:
    FileController(widgets::EditorState& state, QWidget* window);

    void newTheatre();
    void newGround();
    void open();
    void openPath(const QString& path);
    /// All three: false when it was not saved (cancelled, or it could not be written: said in a
    /// dialog).
    bool save();
    bool saveAs();
    /// Copies every foreign asset beside the scene file, points the scene at the copies and saves.
    bool collectAssets();
    /// Asks whether to save when there are unsaved changes; false: the artist wants to stay.
    [[nodiscard]] bool mayLeaveScene();
    /// The window closes for good: nothing to recover.
    void forgetRecovery();
    /// After a crash: offers what was kept of documents that were never saved. True: one is being
    /// opened.
    bool offerUntitledRecovery();
    /// The same, then also of the scenes opened last.
    bool offerRecovery();

    /// The ready-made scenes that come with the program, the theatre first. They open as new
    /// scenes: saving asks for a name.
    [[nodiscard]] static QStringList examples();
    /// Of the open scene, for titles: "party.crowd", or "Untitled".
    [[nodiscard]] QString documentName() const;

    void setAutosaveSeconds(int seconds); ///< 0: off
    [[nodiscard]] bool isBusy() const { return m_task.isRunning(); }

Q_SIGNALS:
    void becameIdle(); ///< what was being opened is there, or never will be
    /// A scene stands in the window; entries without asset have their problem.
    void sceneOpened();

private:
    /// How a file looked when it was read or written last.
    struct FileStamp
    {
        QDateTime modified;
        qint64 size = -1;
        friend bool operator==(const FileStamp&, const FileStamp&) = default;
    };
    /// What is to be read, and as what it then stands in the window.
    struct Opening
    {
        QString documentPath; ///< empty: it is not saved yet
        QString file;
        QString name; ///< of one that is not saved yet; may be empty
        bool isRecovery = false;
        bool isExample = false; ///< it comes with the program
    };
    enum class RecoveryAnswer { Recover, ThrowAway, Cancel };

    [[nodiscard]] static FileStamp stampOf(const QString& path);
    [[nodiscard]] bool mayStart();
    [[nodiscard]] RecoveryAnswer askForRecovery(const QString& question, const QString& recovery);
    /// What to open of a scene file: itself or what a crash left of it; nothing: the artist
    /// cancelled.
    [[nodiscard]] std::optional<Opening> chooseVersion(const QString& path);
    bool offerRecentRecovery();
    [[nodiscard]] QString askForSavePath(const QString& title);
    bool saveUnder(const QString& title);
    [[nodiscard]] bool mayOverwrite(const QString& path);
    /// Asks again when the scene was changed since it had this revision.
    [[nodiscard]] bool mayStillLeaveScene(std::uint64_t revision);
    void load(const Opening& opening);
    void showNew(model::Scene scene);
    void take(model::Scene scene, const Opening& opening);
    bool write(const QString& path);
    void reportOddities();
    void reportFailure(const QString& title, const QString& message);

    widgets::EditorState& m_state;
    QWidget* m_window;
    DialogTask m_task;
    Autosaver m_autosaver;
    FileStamp m_stamp;      ///< of the document's file
    QString m_untitledName; ///< of the example that was opened
};

} // namespace crowd::app
