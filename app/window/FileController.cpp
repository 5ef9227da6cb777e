// SPDX-License-Identifier: MIT
#include "app/window/FileController.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QSettings>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QMessageBox>

#include "model/document/SceneEdit.h"
#include "model/project/Autosave.h"
#include "model/project/CollectAssets.h"
#include "model/project/ProjectFile.h"
#include "model/project/SceneAssets.h"

namespace crowd::app {

namespace {

constexpr int kMaxRecentFiles = 10;
const QString kRecentKey = QStringLiteral("files/recent");
const QString kSuffix = QStringLiteral(".crowd");

QString sceneFilter()
{
    return QCoreApplication::translate("crowd::app::FileController", "Crowdbrush scenes (*.crowd)");
}

model::LoadProgress loadProgress(const BackgroundTask::Progress& report)
{
    return [report](const std::string& what, float fraction) {
        return report(QCoreApplication::translate("crowd::app::FileController", "Loading %1…")
                          .arg(QString::fromStdString(what)),
                      fraction);
    };
}

} // namespace

FileController::FileController(widgets::EditorState& state, QWidget* window)
    : QObject(window), m_state(state), m_window(window), m_task(window)
{
    connect(&m_autosave, &QTimer::timeout, this, &FileController::autosave);
}

void FileController::newTheatre()
{
    if (mayLeaveScene()) {
        showNew(model::newEmptyTheatre());
    }
}

void FileController::newGround()
{
    if (mayLeaveScene()) {
        showNew(model::newEmptyGround());
    }
}

void FileController::showNew(model::Scene scene)
{
    m_task.start(
        tr("Preparing a new scene…"),
        [scene](const BackgroundTask::Progress& report) {
            model::Scene loaded = scene;
            model::loadAssets(loaded, loadProgress(report));
            return loaded;
        },
        [this](model::Scene loaded) { take(std::move(loaded), {}, false); });
}

void FileController::open()
{
    const QString folder = QFileInfo(m_state.document().path()).absolutePath();
    const QString path =
        QFileDialog::getOpenFileName(m_window, tr("Open Scene"), folder, sceneFilter());
    if (!path.isEmpty()) {
        openPath(path);
    }
}

void FileController::openPath(const QString& path)
{
    if (m_task.isRunning() || !mayLeaveScene()) {
        return;
    }
    const QString recovery = recoveryToUse(path);
    load(recovery.isEmpty() ? path : recovery, path, !recovery.isEmpty());
}

QString FileController::recoveryToUse(const QString& path)
{
    const QString recovery = model::findRecovery(path);
    if (recovery.isEmpty()) {
        return {};
    }
    const auto answer = QMessageBox::question(
        m_window, tr("Recover Unsaved Work"),
        tr("Crowdbrush kept unsaved changes of “%1” from %2. Open them?\n\nOtherwise they are "
           "thrown away and the scene opens as it was saved.")
            .arg(QFileInfo(path).fileName(),
                 QLocale().toString(QFileInfo(recovery).lastModified(), QLocale::ShortFormat)));
    if (answer == QMessageBox::Yes) {
        return recovery;
    }
    QFile::remove(recovery);
    return {};
}

void FileController::load(const QString& file, const QString& documentPath, bool isRecovered)
{
    m_task.start(
        tr("Opening %1…").arg(QFileInfo(documentPath).fileName()),
        [file](const BackgroundTask::Progress& report) {
            return model::loadScene(file, loadProgress(report));
        },
        [this, documentPath, isRecovered](model::Result<model::Scene> scene) {
            if (!scene) {
                reportFailure(tr("The scene could not be opened"), scene.error().message);
                return;
            }
            take(std::move(scene).value(), documentPath, isRecovered);
        });
}

void FileController::take(model::Scene scene, const QString& path, bool isRecovered)
{
    model::removeAutosave(m_state.document().path() == path ? QString()
                                                            : m_state.document().path());
    m_state.selection().clear();
    m_state.document().replaceScene(std::move(scene), path);
    m_isRecovered = isRecovered;
    if (isRecovered) {
        m_state.document().undoStack().resetClean(); // not what the file holds
    }
    if (!m_state.scene().cameras.empty()) {
        const model::NamedCamera& first = m_state.scene().cameras.front();
        m_state.setCamera(first.camera, QString::fromStdString(first.name));
    }
    m_state.transport().rewind();
    if (!path.isEmpty()) {
        remember(path);
    }
    Q_EMIT sceneOpened();
}

bool FileController::save()
{
    const QString path = m_state.document().path();
    return path.isEmpty() ? saveAs() : write(path);
}

bool FileController::saveAs()
{
    QString suggestion = m_state.document().path();
    if (suggestion.isEmpty()) {
        suggestion = tr("Untitled") + kSuffix;
    }
    QString path =
        QFileDialog::getSaveFileName(m_window, tr("Save Scene As"), suggestion, sceneFilter());
    if (path.isEmpty()) {
        return false;
    }
    if (QFileInfo(path).suffix().isEmpty()) {
        path += kSuffix;
    }
    return write(path);
}

bool FileController::write(const QString& path)
{
    if (const auto saved = model::saveProject(m_state.scene(), path); !saved) {
        reportFailure(tr("The scene could not be saved"), saved.error().message);
        return false;
    }
    model::removeAutosave(m_state.document().path());
    m_isRecovered = false;
    m_state.document().markSaved(path);
    remember(path);
    m_state.showStatus(tr("Saved %1").arg(QFileInfo(path).fileName()));
    return true;
}

bool FileController::collectAssets()
{
    if (!save()) {
        return false;
    }
    const auto collected =
        model::collectAssets(m_state.scene(), QFileInfo(m_state.document().path()).absolutePath());
    if (!collected) {
        reportFailure(tr("The assets could not be collected"), collected.error().message);
        return false;
    }
    const auto edit = m_state.document().beginEdit();
    for (const model::TemplateEntry& entry : collected.value().templates) {
        edit->changeTemplate(entry);
    }
    for (const model::StageEntry& entry : collected.value().stages) {
        edit->changeStage(entry);
    }
    edit->commit(tr("Collect Assets"));
    return save();
}

bool FileController::mayLeaveScene()
{
    if (!m_state.document().isModified()) {
        return true;
    }
    const QString name = m_state.document().path().isEmpty()
                             ? tr("Untitled")
                             : QFileInfo(m_state.document().path()).fileName();
    const auto answer = QMessageBox::warning(
        m_window, tr("Unsaved Changes"), tr("“%1” has unsaved changes. Save them?").arg(name),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save) {
        return save();
    }
    return answer == QMessageBox::Discard;
}

void FileController::forgetRecovery()
{
    model::removeAutosave(m_state.document().path());
}

void FileController::offerUntitledRecovery()
{
    for (const QString& recovery : model::findUntitledRecoveries()) {
        const auto answer = QMessageBox::question(
            m_window, tr("Recover Unsaved Work"),
            tr("Crowdbrush kept a scene that was never saved, from %1. Open it?\n\nOtherwise it is "
               "thrown away.")
                .arg(QLocale().toString(QFileInfo(recovery).lastModified(), QLocale::ShortFormat)));
        if (answer == QMessageBox::Yes) {
            load(recovery, {}, true);
            return;
        }
        QFile::remove(recovery);
    }
}

QStringList FileController::recentFiles() const
{
    return QSettings().value(kRecentKey).toStringList();
}

void FileController::clearRecentFiles()
{
    QSettings().remove(kRecentKey);
    Q_EMIT recentFilesChanged();
}

void FileController::remember(const QString& path)
{
    QStringList recent = recentFiles();
    const QString absolute = QFileInfo(path).absoluteFilePath();
    recent.removeAll(absolute);
    recent.prepend(absolute);
    QSettings().setValue(kRecentKey, QStringList(recent.mid(0, kMaxRecentFiles)));
    Q_EMIT recentFilesChanged();
}

void FileController::setAutosaveSeconds(int seconds)
{
    m_autosave.stop();
    if (seconds > 0) {
        m_autosave.start(seconds * 1000);
    }
}

void FileController::autosave()
{
    const QUndoStack& stack = m_state.document().undoStack();
    const QUndoCommand* top = stack.index() > 0 ? stack.command(stack.index() - 1) : nullptr;
    const bool isUnchanged = top == m_savedAt && top != nullptr;
    if (!m_state.document().isModified() || m_state.document().isEditOpen() || isUnchanged) {
        return;
    }
    const auto saved = model::writeAutosave(m_state.scene(), m_state.document().path());
    if (!saved) {
        m_state.showStatus(QString::fromStdString(saved.error().message));
        return;
    }
    m_savedAt = top;
}

void FileController::reportFailure(const QString& title, const std::string& message)
{
    QMessageBox::critical(m_window, title, QString::fromStdString(message));
}

} // namespace crowd::app
