// SPDX-License-Identifier: MIT
#include "app/window/AssetController.h"

#include <algorithm>

#include <QtCore/QFileInfo>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>

#include "model/base/Translated.h"
#include "model/document/SceneEdit.h"
#include "model/gltf/GltfImport.h"
#include "model/gltf/ImportProposal.h"
#include "model/project/SceneAssets.h"
#include "widgets/commands/ViewCommands.h"
#include "widgets/dialogs/ClipsDialog.h"
#include "widgets/dialogs/ImportDialog.h"
#include "widgets/dialogs/LibraryDialog.h"
#include "widgets/dialogs/MissingAssetsDialog.h"

namespace crowd::app {

namespace {

using model::Result;

model::ImportProgress importProgress(const widgets::TaskReport& report, const QString& name)
{
    return [report, name](float fraction) { return report(name, fraction); };
}

// lupdate would take model:: before the name for the context of what is said in it.
using Loaded = model::LoadProgress;

Loaded loadProgress(const widgets::TaskReport& report)
{
    return [report](const std::string& what, float fraction) {
        return report(AssetController::tr("Reading %1…").arg(QString::fromStdString(what)),
                      fraction);
    };
}

QString fileName(const QString& path)
{
    return QFileInfo(path).fileName();
}

std::string entryName(const QString& path)
{
    return QFileInfo(path).completeBaseName().toStdString();
}

/// The new templates are what the create brush paints until the artist mixes in others.
void paintWith(widgets::EditorState& state, const std::vector<model::TemplateId>& ids)
{
    model::BrushSettings brush = state.brush(model::BrushKind::Create);
    brush.as<model::CreateSettings>().mix.clear();
    for (const model::TemplateId id : ids) {
        brush.as<model::CreateSettings>().mix.push_back({id, 1.0F});
    }
    state.setBrush(brush);
}

QString modelFilter()
{
    return AssetController::tr("glTF models (*.glb *.gltf);;All files (*)");
}

/// With which of them it is, where several came together.
QString titleOf(const QString& path, QueuePlace place)
{
    return place.count > 1 ? AssetController::tr("Import %1 (%2 of %3)")
                                 .arg(fileName(path))
                                 .arg(place.number)
                                 .arg(place.count)
                           : AssetController::tr("Import %1").arg(fileName(path));
}

/// The deepest folder on the way to a file that is still there.
QString nearestFolder(const QString& path)
{
    QString folder = QFileInfo(path).path();
    while (!QFileInfo(folder).isDir() && folder.contains(QLatin1Char('/')) && folder.size() > 1) {
        folder = QFileInfo(folder).path();
    }
    return folder;
}

} // namespace

AssetController::AssetController(widgets::EditorState& state, QWidget* window)
    : QObject(window), m_state(state), m_window(window),
      m_task(window, [&state] { return !state.document().isEditOpen(); })
{
    connect(&m_task, &DialogTask::ended, this, &AssetController::goOn);
}

void AssetController::goOn()
{
    if (m_task.isRunning() || m_dialog != nullptr) {
        return;
    }
    if (!m_waiting.isEmpty()) {
        const int count = m_proposed + static_cast<int>(m_waiting.size());
        proposeTemplate(m_waiting.takeFirst(), {++m_proposed, count});
        return;
    }
    m_proposed = 0;
    m_batch.clear();
    Q_EMIT becameIdle();
}

void AssetController::show(QDialog* dialog)
{
    m_dialog = dialog;
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::finished, this, [this] {
        m_dialog = nullptr;
        goOn();
    });
    dialog->open();
}

QString AssetController::askForModel(const QString& title)
{
    return QFileDialog::getOpenFileName(m_window, title, {}, modelFilter());
}

void AssetController::importTemplate()
{
    importTemplates(
        QFileDialog::getOpenFileNames(m_window, tr("Import Templates"), {}, modelFilter()));
}

void AssetController::importTemplates(const QStringList& paths)
{
    const bool isFree = !isBusy();
    m_waiting += paths;
    if (isFree) {
        goOn();
    }
}

void AssetController::addFromLibrary()
{
    if (isBusy()) {
        return;
    }
    m_task.start(
        tr("Reading the library…"),
        [](const widgets::TaskReport& report) {
            model::Scene library;
            library.templates = model::builtinCast();
            model::loadAssets(library, loadProgress(report));
            return library.templates;
        },
        [this](std::vector<model::TemplateEntry> library) {
            if (library.empty()) {
                fail(tr("There is no library"),
                     tr("The built-in characters were not found. Install them beside the program "
                        "or name their folder in CROWDBRUSH_RESOURCES."));
                return;
            }
            auto* dialog = new widgets::LibraryDialog(std::move(library), m_state.scene().templates,
                                                      m_state.keyframes(), m_window);
            connect(dialog, &QDialog::accepted, this,
                    [this, dialog] { addEntries(dialog->chosen()); });
            show(dialog);
        });
}

/// In one undo step.
void AssetController::addEntries(std::vector<model::TemplateEntry> entries)
{
    if (entries.empty()) {
        return;
    }
    m_state.document().interruptEdit();
    std::vector<model::TemplateId> ids;
    const QString text = tr("Add %n template(s)", nullptr, static_cast<int>(entries.size()));
    m_state.document().edit(text, [&](model::SceneEdit& edit) {
        for (model::TemplateEntry& entry : entries) {
            entry.id = 0; // the scene gives it one
            ids.push_back(edit.addTemplate(entry));
        }
    });
    paintWith(m_state, ids);
    m_state.showStatus(tr("%n template(s) ready: the create brush paints them.", nullptr,
                          static_cast<int>(ids.size())));
    for (const model::TemplateId id : ids) {
        Q_EMIT templateAdded(id);
    }
}

void AssetController::importStage()
{
    if (const QString path = askForModel(tr("Import Stage")); !path.isEmpty()) {
        addStage(path);
    }
}

std::optional<bool> AssetController::askIsStage(const QString& path, bool looksLikeStage,
                                                QueuePlace place)
{
    QMessageBox box(
        QMessageBox::Question, titleOf(path, place),
        tr("Use “%1” as a template to paint with, or as the stage?").arg(fileName(path)),
        QMessageBox::Cancel, m_window);
    QPushButton* asTemplate = box.addButton(tr("&Template"), QMessageBox::AcceptRole);
    QPushButton* asStage = box.addButton(tr("&Stage"), QMessageBox::AcceptRole);
    box.setDefaultButton(looksLikeStage ? asStage : asTemplate);
    const int rest = place.count - place.number;
    if (rest > 0) {
        box.setCheckBox(new QCheckBox(tr("The same for the %n other file(s)", nullptr, rest)));
    }
    box.exec();
    if (box.clickedButton() != asTemplate && box.clickedButton() != asStage) {
        return std::nullopt;
    }
    const bool isStage = box.clickedButton() == asStage;
    if (rest > 0 && box.checkBox()->isChecked()) {
        m_restIsStage = isStage;
    }
    return isStage;
}

void AssetController::bring(const QString& path, bool asks, QueuePlace place)
{
    if (place.number == 1) {
        m_restIsStage.reset();
    }
    const model::FileKind kind = model::sniffKind(path.toStdString());
    bool isStage = kind == model::FileKind::Stage;
    if (asks && kind != model::FileKind::Unknown) { // importing tells what is wrong with it
        const std::optional<bool> chosen =
            m_restIsStage ? m_restIsStage : askIsStage(path, isStage, place);
        if (!chosen) {
            return;
        }
        isStage = *chosen;
    }
    if (isStage) {
        addStage(path);
    } else {
        proposeTemplate(path, place);
    }
}

void AssetController::proposeTemplate(const QString& path, QueuePlace place)
{
    if (m_task.isRunning()) {
        return;
    }
    if (place.number == 1) {
        m_takesProposals = false;
    }
    m_task.start(
        tr("Reading %1…").arg(fileName(path)),
        [path](const widgets::TaskReport& report) {
            return model::importTemplate(path.toStdString(), {},
                                         importProgress(report, fileName(path)));
        },
        [this, path, place](const Result<model::TemplatePtr>& asset) {
            if (!asset) {
                fail(tr("The template could not be imported"), model::translated(asset.error()));
            } else if (m_takesProposals) {
                addTemplate(path, model::proposeImport(*asset.value()).settings);
            } else {
                showProposal(path, asset.value(), place);
            }
        });
}

void AssetController::showProposal(const QString& path, const model::TemplatePtr& asset,
                                   QueuePlace place)
{
    auto* dialog = new widgets::ImportDialog(path, asset, m_state.keyframes(), m_window);
    dialog->setWindowTitle(titleOf(path, place));
    if (place.number < place.count) {
        dialog->offerRest(place.count - place.number);
    }
    connect(dialog, &QDialog::accepted, this, [this, dialog, path] {
        m_takesProposals = dialog->isForRest();
        addTemplate(path, dialog->settings(), dialog->clipSpeeds(), dialog->clipRoles());
    });
    show(dialog);
}

void AssetController::addTemplate(const QString& path, const model::ImportSettings& settings,
                                  const std::vector<float>& clipSpeeds,
                                  const std::vector<std::optional<model::ClipRole>>& clipRoles)
{
    if (m_task.isRunning()) {
        return;
    }
    model::TemplateEntry entry;
    entry.name = entryName(path);
    entry.path = QFileInfo(path).absoluteFilePath().toStdString();
    entry.import = settings;
    entry.clipSpeeds = clipSpeeds;
    entry.clipRoles = clipRoles;
    m_task.start(
        tr("Importing %1…").arg(fileName(path)),
        [path, settings](const widgets::TaskReport& report) {
            return model::importTemplate(path.toStdString(), settings,
                                         importProgress(report, fileName(path)));
        },
        [this, entry](const Result<model::TemplatePtr>& asset) {
            if (!asset) {
                fail(tr("The template could not be imported"), model::translated(asset.error()));
                return;
            }
            put(entry, asset.value(), tr("Import template"));
        });
}

void AssetController::put(model::TemplateEntry entry, const model::TemplatePtr& asset,
                          const QString& undoText)
{
    model::attachAsset(entry, asset);
    model::TemplateId id = 0;
    const auto outcome = m_state.document().edit(
        undoText, [&](model::SceneEdit& edit) { id = edit.addTemplate(entry); });
    if (outcome == model::EditOutcome::Refused) {
        return;
    }
    m_batch.push_back(id);
    paintWith(m_state, m_batch);
    m_state.showStatus(
        tr("“%1” is ready: the create brush paints it.").arg(QString::fromStdString(entry.name)));
    Q_EMIT templateAdded(id);
}

void AssetController::addStage(const QString& path)
{
    if (m_task.isRunning()) {
        return;
    }
    m_task.start(
        tr("Importing %1…").arg(fileName(path)),
        [path](const widgets::TaskReport& report) {
            return model::importStage(path.toStdString(), importProgress(report, fileName(path)));
        },
        [this, path](const Result<model::StagePtr>& asset) {
            if (!asset) {
                fail(tr("The stage could not be imported"), model::translated(asset.error()));
                return;
            }
            model::StageEntry entry;
            entry.name = entryName(path);
            entry.path = QFileInfo(path).absoluteFilePath().toStdString();
            entry.asset = asset.value();
            const auto outcome =
                m_state.document().edit(tr("Import stage"), [&](model::SceneEdit& edit) {
                    Q_EMIT stageAdded(edit.addStage(entry));
                });
            if (outcome != model::EditOutcome::Refused) {
                widgets::frameAll(m_state); // it may be anywhere, and of any size
            }
        });
}

void AssetController::removeTemplate(model::TemplateId id)
{
    const auto used = m_state.scene().population.column(model::columns::templateId);
    const auto users = std::ranges::count(used, id);
    if (users > 0) {
        m_state.showStatus(tr("%n characters are of this template; delete them first.", nullptr,
                              static_cast<int>(users)));
        return;
    }
    m_state.document().edit(tr("Remove template"),
                            [&](model::SceneEdit& edit) { edit.removeTemplate(id); });
}

void AssetController::editClips(model::TemplateId id)
{
    const model::TemplateEntry* entry = m_state.scene().findTemplate(id);
    if (entry == nullptr || m_task.isRunning()) {
        return;
    }
    // As the file has it: what the artist has changed can be taken back.
    const QString name = QString::fromStdString(entry->name);
    m_task.start(
        tr("Reading %1…").arg(name),
        [entry = *entry](const widgets::TaskReport& report) -> Result<model::TemplatePtr> {
            auto asset = model::loadTemplateAsset(entry, loadProgress(report));
            if (!asset) {
                return asset.error();
            }
            model::TemplateEntry plain = entry;
            plain.clipSpeeds.clear();
            plain.clipRoles.clear();
            model::attachAsset(plain, asset.value());
            return plain.asset;
        },
        [this, id](const Result<model::TemplatePtr>& asset) {
            if (!asset) {
                fail(tr("The file could not be read"), model::translated(asset.error()));
                return;
            }
            showClips(id, asset.value());
        });
}

void AssetController::showClips(model::TemplateId id, const model::TemplatePtr& asset)
{
    const model::TemplateEntry* entry = m_state.scene().findTemplate(id);
    if (entry == nullptr) {
        return; // it was removed meanwhile
    }
    auto* dialog = new widgets::ClipsDialog(*entry, asset, m_state.keyframes(), m_window);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog, id, asset] { setClips(id, asset, *dialog); });
    show(dialog);
}

void AssetController::setClips(model::TemplateId id, const model::TemplatePtr& asset,
                               const widgets::ClipsDialog& dialog)
{
    const model::TemplateEntry* entry = m_state.scene().findTemplate(id);
    if (entry == nullptr) {
        return;
    }
    model::TemplateEntry changed = *entry;
    changed.clipSpeeds = dialog.clipSpeeds();
    changed.clipRoles = dialog.clipRoles();
    model::attachAsset(changed, asset);
    m_state.document().interruptEdit();
    m_state.document().edit(tr("Change clips"),
                            [&](model::SceneEdit& edit) { edit.changeTemplate(changed); });
}

void AssetController::locateTemplate(model::TemplateId id)
{
    if (const model::TemplateEntry* entry = m_state.scene().findTemplate(id)) {
        locate({false, id, entry->name, entry->path, entry->problem});
    }
}

void AssetController::locateStage(std::uint8_t id)
{
    if (const model::StageEntry* entry = m_state.scene().findStage(id)) {
        locate({true, id, entry->name, entry->path, entry->problem});
    }
}

void AssetController::locate(const model::MissingAsset& asset)
{
    const QString was = QString::fromStdString(asset.path);
    const QString path = QFileDialog::getOpenFileName(
        m_window, tr("Locate “%1” (%2)").arg(QString::fromStdString(asset.name), fileName(was)),
        nearestFolder(was), modelFilter());
    if (!path.isEmpty()) {
        locateAt(asset, path);
    }
}

void AssetController::locateAt(const model::MissingAsset& asset, const QString& path)
{
    if (m_task.isRunning()) {
        return;
    }
    const model::Scene scene = m_state.scene(); // columns and assets are shared
    m_task.start(
        tr("Reading %1…").arg(fileName(path)),
        [scene, asset, path](const widgets::TaskReport& report) {
            return findAssets(scene, asset, path.toStdString(), loadProgress(report));
        },
        [this](const Result<FoundAssets>& found) {
            if (!found) {
                fail(tr("The file could not be read"), model::translated(found.error()));
                return;
            }
            take(found.value());
        });
}

/// The entries may have changed while the files were read: only paths and assets are new.
void AssetController::take(const FoundAssets& found)
{
    m_state.document().edit(tr("Locate assets"), [&](model::SceneEdit& edit) {
        for (const auto& [id, path, asset] : found.templates) {
            if (const model::TemplateEntry* entry = m_state.scene().findTemplate(id)) {
                model::TemplateEntry whole = *entry;
                whole.path = path;
                model::attachAsset(whole, asset);
                edit.changeTemplate(whole);
            }
        }
        for (const auto& [id, path, asset] : found.stages) {
            if (const model::StageEntry* entry = m_state.scene().findStage(id)) {
                model::StageEntry whole = *entry;
                whole.path = path;
                whole.asset = asset;
                whole.problem = {};
                edit.changeStage(whole);
            }
        }
    });
    m_state.showStatus(tr("%n asset(s) found.", nullptr,
                          static_cast<int>(found.templates.size() + found.stages.size())));
}

void AssetController::reportMissing()
{
    if (model::missingAssets(m_state.scene()).empty()) {
        return;
    }
    auto* dialog = new widgets::MissingAssetsDialog(m_state, m_window);
    connect(dialog, &widgets::MissingAssetsDialog::locateRequested, this, &AssetController::locate);
    show(dialog);
}

void AssetController::fail(const QString& title, const QString& message)
{
    auto* box = new QMessageBox(QMessageBox::Critical, title, message, QMessageBox::Ok, m_window);
    box->setObjectName(QStringLiteral("importFailure"));
    show(box);
}

} // namespace crowd::app
