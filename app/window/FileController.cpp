// SPDX-License-Identifier: MIT
#include "app/window/FileController.h"

#include <utility>

#include <QtCore/QCoreApplication>
#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QLocale>
#include <QtCore/QStandardPaths>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>

#include "app/window/ReadyNames.h"
#include "app/window/RecentFiles.h"
#include "model/base/Translated.h"
#include "model/document/SceneEdit.h"
#include "model/project/AssetPaths.h"
#include "model/project/Autosave.h"
#include "model/project/CollectAssets.h"
#include "model/project/ProjectFile.h"
#include "model/project/SceneAssets.h"

namespace crowd::app {

namespace {

const QString kSuffix = QStringLiteral("crowd");

QString sceneFilter()
{
    return QCoreApplication::translate("crowd::app::FileController", "Crowdbrush scenes (*.crowd)");
}

model::LoadProgress sceneProgress(const widgets::TaskReport& report)
{
    return [report](const std::string& what, float fraction) {
        return report(QCoreApplication::translate("crowd::app::FileController", "Loading %1…")
                          .arg(QString::fromStdString(what)),
                      fraction);
    };
}

/// Where the artist was last.
QString usualFolder(const QString& documentPath)
{
    if (!documentPath.isEmpty()) {
        return QFileInfo(documentPath).absolutePath();
    }
    const QStringList recent = recentFiles();
    return recent.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                            : QFileInfo(recent.front()).absolutePath();
}

/// Qt's own dialog takes what stands between quotes for the names: they belong to the name.
bool isQuoted(const QFileDialog& dialog)
{
    const auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    return name != nullptr && name->text().contains(QLatin1Char('"'));
}

QString chosenPath(const QFileDialog& dialog)
{
    return isQuoted(dialog)
               ? dialog.directory().absoluteFilePath(
                     dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->text())
               : dialog.selectedFiles().front();
}

/// By what an artist knows a scene again: how many people, and where. Empty: it cannot be read,
/// which opening it will say.
QString whatIsIn(const QString& project)
{
    const auto scene = model::readProject(project);
    if (!scene) {
        return {};
    }
    const QString people = FileController::tr("It has %n character(s).", nullptr,
                                              static_cast<int>(scene.value().population.size()));
    QStringList stages;
    for (const model::StageEntry& stage : scene.value().stages) {
        stages << QString::fromStdString(stage.name);
    }
    return stages.isEmpty()
               ? people
               : FileController::tr("%1 Stage: %2.").arg(people, stages.join(QStringLiteral(", ")));
}

} // namespace

FileController::FileController(widgets::EditorState& state, QWidget* window)
    : QObject(window), m_state(state), m_window(window),
      m_task(window, [&state] { return !state.document().isEditOpen(); }), m_autosaver(state, this)
{
    connect(&m_task, &DialogTask::ended, this, &FileController::becameIdle);
}

FileController::FileStamp FileController::stampOf(const QString& path)
{
    const QFileInfo file(path);
    return file.exists() ? FileStamp{file.lastModified(), file.size()} : FileStamp{};
}

/// One thing at a time, and never in the middle of a stroke.
bool FileController::mayStart()
{
    if (m_task.isRunning()) {
        m_state.showStatus(tr("Another scene is being opened; wait for it or cancel it first."));
        return false;
    }
    if (m_state.document().isEditOpen()) {
        m_state.showStatus(tr("Finish or cancel (Esc) what you are doing first."));
        return false;
    }
    return true;
}

void FileController::newTheatre()
{
    if (mayStart() && mayLeaveScene()) {
        showNew(model::newEmptyTheatre());
    }
}

void FileController::newGround()
{
    if (mayStart() && mayLeaveScene()) {
        showNew(model::newEmptyGround());
    }
}

void FileController::showNew(model::Scene scene)
{
    const std::uint64_t revision = m_state.document().revision();
    m_task.start(
        tr("Preparing a new scene…"),
        [scene = std::move(scene)](const widgets::TaskReport& report) {
            model::Scene loaded = scene;
            model::loadAssets(loaded, sceneProgress(report));
            return loaded;
        },
        [this, revision](model::Scene loaded) {
            if (mayStillLeaveScene(revision)) {
                take(std::move(loaded), {});
            }
        });
}

void FileController::open()
{
    if (!mayStart()) {
        return;
    }
    const QString path = QFileDialog::getOpenFileName(
        m_window, tr("Open Scene"), usualFolder(m_state.document().path()), sceneFilter());
    if (!path.isEmpty()) {
        openPath(path);
    }
}

void FileController::openPath(const QString& path)
{
    if (!mayStart()) {
        return;
    }
    if (!QFileInfo::exists(path)) {
        removeRecentFile(path);
        reportFailure(tr("The scene could not be opened"),
                      tr("%1 is not there any more. It was moved, renamed or deleted; choose "
                         "File > Open to look for it.")
                          .arg(path));
        return;
    }
    if (!mayLeaveScene()) {
        return;
    }
    if (const QFileInfo file(path); examples().contains(file.absoluteFilePath())) {
        load({{}, path, exampleName(path), false, true});
        return;
    }
    if (const auto opening = chooseVersion(path)) {
        load(*opening);
    }
}

std::optional<FileController::Opening> FileController::chooseVersion(const QString& path)
{
    for (QString recovery = model::findRecovery(path); !recovery.isEmpty();
         recovery = model::findRecovery(path)) {
        const RecoveryAnswer answer =
            askForRecovery(tr("Crowdbrush kept unsaved changes of “%1” from %2. Recover "
                              "them?\n\nThrown away, they "
                              "are gone and the scene opens as it was saved.")
                               .arg(QFileInfo(path).fileName()),
                           recovery);
        if (answer == RecoveryAnswer::Recover) {
            return Opening{path, recovery, {}, true};
        }
        if (answer != RecoveryAnswer::ThrowAway) {
            return {};
        }
        if (!QFile::remove(recovery)) {
            break;
        }
    }
    return Opening{path, path, {}, false};
}

FileController::RecoveryAnswer FileController::askForRecovery(const QString& question,
                                                              const QString& recovery)
{
    const QString when =
        QLocale().toString(QFileInfo(recovery).lastModified(), QLocale::ShortFormat);
    QMessageBox box(QMessageBox::Question, tr("Recover Unsaved Work"), question.arg(when),
                    QMessageBox::Yes | QMessageBox::No | QMessageBox::Cancel, m_window);
    box.setInformativeText(whatIsIn(recovery));
    box.button(QMessageBox::Yes)->setText(tr("&Recover"));
    box.button(QMessageBox::No)->setText(tr("&Throw Away"));
    box.button(QMessageBox::Cancel)->setText(tr("&Not Now")); // it is asked again
    box.setDefaultButton(QMessageBox::Yes);
    box.setEscapeButton(QMessageBox::Cancel); // closing the question decides nothing
    switch (box.exec()) {
    case QMessageBox::Yes:
        return RecoveryAnswer::Recover;
    case QMessageBox::No:
        return RecoveryAnswer::ThrowAway;
    default:
        return RecoveryAnswer::Cancel;
    }
}

bool FileController::offerUntitledRecovery()
{
    for (const QString& recovery : model::findUntitledRecoveries()) {
        const RecoveryAnswer answer = askForRecovery(
            tr("Crowdbrush kept a scene that was never saved, from %1. Recover it?\n\nThrown away, "
               "it is gone."),
            recovery);
        if (answer == RecoveryAnswer::Recover && mayStart() && mayLeaveScene()) {
            load({{}, recovery, {}, true});
            return true;
        }
        if (answer == RecoveryAnswer::ThrowAway) {
            QFile::remove(recovery);
        }
    }
    return false;
}

bool FileController::offerRecovery()
{
    return offerUntitledRecovery() || offerRecentRecovery();
}

/// The artist may not remember which scene it was. Thrown away, no scene opens: none was asked for.
bool FileController::offerRecentRecovery()
{
    for (const QString& path : recentFiles()) {
        if (model::findRecovery(path).isEmpty() || model::isKeptByAnother(path)) {
            continue;
        }
        const auto opening = chooseVersion(path);
        if (opening && opening->isRecovery && mayStart() && mayLeaveScene()) {
            load(*opening);
            return true;
        }
    }
    return false;
}

QStringList FileController::examples()
{
    const QDir folder(model::builtinFolder() + QStringLiteral("/scenes"));
    QStringList paths;
    for (const QString& name :
         folder.entryList({QStringLiteral("*.") + kSuffix}, QDir::Files, QDir::Name)) {
        const QString path = QFileInfo(folder.filePath(name)).absoluteFilePath();
        name == QLatin1String("theatre.crowd") ? paths.prepend(path) : paths.append(path);
    }
    return paths;
}

QString FileController::documentName() const
{
    const QString path = m_state.document().path();
    if (!path.isEmpty()) {
        return QFileInfo(path).fileName();
    }
    return m_untitledName.isEmpty() ? tr("Untitled") : m_untitledName;
}

void FileController::load(const Opening& opening)
{
    const QString shown = opening.documentPath.isEmpty() ? opening.file : opening.documentPath;
    const FileStamp stamp = stampOf(opening.documentPath);
    const std::uint64_t revision = m_state.document().revision();
    m_task.start(
        tr("Opening %1…").arg(QFileInfo(shown).fileName()),
        [file = opening.file](const widgets::TaskReport& report) {
            return model::loadScene(file, sceneProgress(report));
        },
        [this, opening, stamp, revision](model::Result<model::Scene> scene) {
            if (!scene) {
                reportFailure(tr("The scene could not be opened"),
                              model::translated(scene.error()));
                return;
            }
            if (mayStillLeaveScene(revision)) {
                if (opening.isExample) {
                    translateNames(scene.value());
                }
                take(std::move(scene).value(), opening);
                m_stamp = stamp;
            }
        });
}

void FileController::take(model::Scene scene, const Opening& opening)
{
    m_autosaver.forget(); // of the scene that goes; the artist was asked
    m_state.selection().clear();
    m_untitledName = opening.name;
    m_state.document().replaceScene(std::move(scene), opening.documentPath);
    m_stamp = {};
    if (opening.isRecovery) {
        m_state.document().undoStack().resetClean(); // not what the file holds
        m_autosaver.adopt(opening.file);
    }
    m_state.transport().rewind();
    m_state.showStatus({}); // what was done to the one before
    if (!opening.documentPath.isEmpty()) {
        addRecentFile(opening.documentPath);
    }
    Q_EMIT sceneOpened();
    reportOddities();
}

void FileController::reportOddities()
{
    QStringList odd;
    for (const model::Message& warning : m_state.scene().readWarnings) {
        odd << model::translated(warning);
    }
    if (odd.isEmpty()) {
        return;
    }
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Open Scene"), odd.join(QLatin1Char('\n')),
                                QMessageBox::Ok, m_window);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

bool FileController::save()
{
    const QString path = m_state.document().path();
    if (path.isEmpty()) {
        return saveAs();
    }
    return mayOverwrite(path) && write(path);
}

/// Another editor or program may have written the file since it was read.
bool FileController::mayOverwrite(const QString& path)
{
    const FileStamp now = stampOf(path);
    if (now.size < 0 || m_stamp.size < 0 || now == m_stamp) {
        return true;
    }
    QMessageBox box(QMessageBox::Warning, tr("Changed on Disk"),
                    tr("“%1” was changed by another program since it was opened here. Saving "
                       "replaces that version.")
                        .arg(QFileInfo(path).fileName()),
                    QMessageBox::Save | QMessageBox::Cancel, m_window);
    box.button(QMessageBox::Save)->setText(tr("&Replace It"));
    box.setInformativeText(tr("To keep both, cancel and choose File > Save As."));
    box.setDefaultButton(QMessageBox::Cancel);
    return box.exec() == QMessageBox::Save;
}

QString FileController::askForSavePath(const QString& title)
{
    QString suggestion = m_state.document().path();
    if (suggestion.isEmpty()) {
        suggestion =
            usualFolder({}) + QLatin1Char('/') + documentName() + QLatin1Char('.') + kSuffix;
    }
    QFileDialog dialog(m_window, title, QFileInfo(suggestion).absolutePath(), sceneFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(kSuffix);
    dialog.selectFile(QFileInfo(suggestion).fileName());
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) {
        return {};
    }
    QString path = chosenPath(dialog);
    const bool hasSuffix = QFileInfo(path).suffix().compare(kSuffix, Qt::CaseInsensitive) == 0;
    if (hasSuffix && !isQuoted(dialog)) {
        return path;
    }
    // "scene.final" is a name, not a kind of file; the dialog has asked about another one.
    const QString whole = hasSuffix ? path : path + QLatin1Char('.') + kSuffix;
    const bool mayReplace =
        !QFileInfo::exists(whole) ||
        QMessageBox::question(
            m_window, tr("Save Scene As"),
            tr("“%1” exists already. Replace it?").arg(QFileInfo(whole).fileName()),
            QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes;
    return mayReplace ? whole : QString();
}

bool FileController::saveAs()
{
    return saveUnder(tr("Save Scene As"));
}

bool FileController::saveUnder(const QString& title)
{
    const QString path = mayStart() ? askForSavePath(title) : QString();
    return !path.isEmpty() && write(path);
}

bool FileController::write(const QString& path)
{
    if (!mayStart()) {
        return false;
    }
    if (const auto saved = model::saveProject(m_state.scene(), path); !saved) {
        reportFailure(tr("The scene could not be saved"), model::translated(saved.error()));
        return false;
    }
    m_autosaver.forget();
    m_stamp = stampOf(path);
    m_state.document().markSaved(path);
    model::removeOldRecoveries(path);
    addRecentFile(path);
    m_state.showStatus(tr("Saved %1").arg(QFileInfo(path).fileName()));
    return true;
}

bool FileController::collectAssets()
{
    const bool isSaved = m_state.document().path().isEmpty()
                             ? saveUnder(tr("Save Scene As: Its Files Are Collected Beside It"))
                             : save();
    if (!isSaved) {
        return false;
    }
    const auto collected =
        model::collectAssets(m_state.scene(), QFileInfo(m_state.document().path()).absolutePath());
    if (!collected) {
        reportFailure(tr("The assets could not be collected"),
                      model::translated(collected.error()));
        return false;
    }
    m_state.document().edit(tr("Collect assets"), [&](model::SceneEdit& edit) {
        for (const model::TemplateEntry& entry : collected.value().templates) {
            edit.changeTemplate(entry);
        }
        for (const model::StageEntry& entry : collected.value().stages) {
            edit.changeStage(entry);
        }
    });
    if (!save()) {
        return false;
    }
    if (const QStringList& left = collected.value().leftBehind; !left.isEmpty()) {
        QMessageBox::information(m_window, tr("Collect Assets"),
                                 tr("These files are missing and could not be collected:") +
                                     QStringLiteral("\n\n") + left.join(QLatin1Char('\n')));
    }
    return true;
}

bool FileController::mayStillLeaveScene(std::uint64_t revision)
{
    return m_state.document().revision() == revision || mayLeaveScene();
}

bool FileController::mayLeaveScene()
{
    if (!m_state.document().isModified()) {
        return true;
    }
    const auto answer = QMessageBox::warning(
        m_window, tr("Unsaved Changes"),
        tr("“%1” has unsaved changes. Save them?").arg(documentName()),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save) {
        return save();
    }
    return answer == QMessageBox::Discard;
}

void FileController::forgetRecovery()
{
    m_autosaver.forget();
}

void FileController::setAutosaveSeconds(int seconds)
{
    m_autosaver.setSeconds(seconds);
}

void FileController::reportFailure(const QString& title, const QString& message)
{
    QMessageBox::critical(m_window, title, message);
}

} // namespace crowd::app
