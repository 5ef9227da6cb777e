// SPDX-License-Identifier: MIT
#include "app/window/AssetController.h"

#include <algorithm>

#include <QtCore/QFileInfo>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>

#include "model/document/SceneEdit.h"
#include "model/gltf/GltfImport.h"
#include "model/gltf/ImportProposal.h"
#include "model/project/SceneAssets.h"
#include "widgets/dialogs/ImportDialog.h"

namespace crowd::app {

namespace {

using model::Result;

model::ImportProgress importProgress(const BackgroundTask::Progress& report, const QString& name)
{
    return [report, name](float fraction) { return report(name, fraction); };
}

QString fileName(const QString& path)
{
    return QFileInfo(path).fileName();
}

std::string entryName(const QString& path)
{
    return QFileInfo(path).completeBaseName().toStdString();
}

/// The new template is what the create brush paints until the artist mixes in others.
void paintWith(widgets::EditorState& state, model::TemplateId id)
{
    model::BrushSettings brush = state.brush(model::BrushKind::Create);
    brush.create.mix = {{id, 1.0F}};
    state.setBrush(brush);
}

} // namespace

AssetController::AssetController(widgets::EditorState& state, QWidget* window)
    : QObject(window), m_state(state), m_window(window), m_task(window)
{
}

QString AssetController::askForModel(const QString& title)
{
    return QFileDialog::getOpenFileName(m_window, title, {},
                                        tr("glTF models (*.glb *.gltf);;All files (*)"));
}

void AssetController::importTemplate()
{
    if (const QString path = askForModel(tr("Import Template")); !path.isEmpty()) {
        proposeTemplate(path);
    }
}

void AssetController::importStage()
{
    if (const QString path = askForModel(tr("Import Stage")); !path.isEmpty()) {
        addStage(path);
    }
}

void AssetController::bring(const QString& path, bool asks)
{
    bool isStage = model::sniffKind(path.toStdString()) == model::FileKind::Stage;
    if (asks) {
        QMessageBox box(
            QMessageBox::Question, tr("Import %1").arg(fileName(path)),
            tr("Use “%1” as a template to paint with, or as the stage?").arg(fileName(path)),
            QMessageBox::Cancel, m_window);
        QPushButton* asTemplate = box.addButton(tr("&Template"), QMessageBox::AcceptRole);
        QPushButton* asStage = box.addButton(tr("&Stage"), QMessageBox::AcceptRole);
        box.setDefaultButton(isStage ? asStage : asTemplate);
        box.exec();
        if (box.clickedButton() != asTemplate && box.clickedButton() != asStage) {
            return;
        }
        isStage = box.clickedButton() == asStage;
    }
    if (isStage) {
        addStage(path);
    } else {
        proposeTemplate(path);
    }
}

void AssetController::proposeTemplate(const QString& path)
{
    if (m_task.isRunning()) {
        return;
    }
    m_task.start(
        tr("Reading %1…").arg(fileName(path)),
        [path](const BackgroundTask::Progress& report) {
            return model::importTemplate(path.toStdString(), {},
                                         importProgress(report, fileName(path)));
        },
        [this, path](const Result<model::TemplatePtr>& asset) {
            if (!asset) {
                fail(tr("The template could not be imported"), asset.error().message);
                return;
            }
            auto* dialog =
                new widgets::ImportDialog(path, asset.value(), m_state.keyframes(), m_window);
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            connect(dialog, &QDialog::accepted, this, [this, dialog, path] {
                addTemplate(path, dialog->settings(), dialog->clipSpeeds());
            });
            dialog->open();
        });
}

void AssetController::addTemplate(const QString& path, const model::ImportSettings& settings,
                                  const std::vector<float>& clipSpeeds)
{
    if (m_task.isRunning()) {
        return;
    }
    model::TemplateEntry entry;
    entry.name = entryName(path);
    entry.path = QFileInfo(path).absoluteFilePath().toStdString();
    entry.import = settings;
    entry.clipSpeeds = clipSpeeds;
    m_task.start(
        tr("Importing %1…").arg(fileName(path)),
        [path, settings](const BackgroundTask::Progress& report) {
            return model::importTemplate(path.toStdString(), settings,
                                         importProgress(report, fileName(path)));
        },
        [this, entry](const Result<model::TemplatePtr>& asset) {
            if (!asset) {
                fail(tr("The template could not be imported"), asset.error().message);
                return;
            }
            put(entry, asset.value(), tr("Import Template"));
        });
}

void AssetController::put(model::TemplateEntry entry, const model::TemplatePtr& asset,
                          const QString& undoText)
{
    model::attachAsset(entry, asset);
    const auto edit = m_state.document().beginEdit();
    const model::TemplateId id = edit->addTemplate(entry);
    edit->commit(undoText);
    paintWith(m_state, id);
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
        [path](const BackgroundTask::Progress& report) {
            return model::importStage(path.toStdString(), importProgress(report, fileName(path)));
        },
        [this, path](const Result<model::StagePtr>& asset) {
            if (!asset) {
                fail(tr("The stage could not be imported"), asset.error().message);
                return;
            }
            model::StageEntry entry;
            entry.name = entryName(path);
            entry.path = QFileInfo(path).absoluteFilePath().toStdString();
            entry.asset = asset.value();
            const auto edit = m_state.document().beginEdit();
            const std::uint8_t id = edit->addStage(entry);
            edit->commit(tr("Import Stage"));
            Q_EMIT stageAdded(id);
        });
}

void AssetController::removeTemplate(model::TemplateId id)
{
    const auto used = m_state.scene().population.column(model::columns::templateId);
    const auto users = std::ranges::count(used, id);
    if (users > 0) {
        m_state.showStatus(tr("%n people are of this template; delete them first.", nullptr,
                              static_cast<int>(users)));
        return;
    }
    const auto edit = m_state.document().beginEdit();
    edit->removeTemplate(id);
    edit->commit(tr("Remove Template"));
}

void AssetController::locateTemplate(model::TemplateId id)
{
    const model::TemplateEntry* entry = m_state.scene().findTemplate(id);
    if (entry == nullptr) {
        return;
    }
    const QString path = askForModel(tr("Locate “%1”").arg(QString::fromStdString(entry->name)));
    if (path.isEmpty()) {
        return;
    }
    model::TemplateEntry found = *entry;
    found.path = path.toStdString();
    Result<model::TemplatePtr> asset = model::loadTemplateAsset(found);
    if (!asset) {
        fail(tr("The template could not be read"), asset.error().message);
        return;
    }
    model::attachAsset(found, asset.value());
    const auto edit = m_state.document().beginEdit();
    edit->changeTemplate(found);
    edit->commit(tr("Locate Template"));
}

void AssetController::locateStage(std::uint8_t id)
{
    const model::StageEntry* entry = m_state.scene().findStage(id);
    if (entry == nullptr) {
        return;
    }
    const QString path = askForModel(tr("Locate “%1”").arg(QString::fromStdString(entry->name)));
    if (path.isEmpty()) {
        return;
    }
    model::StageEntry found = *entry;
    found.path = path.toStdString();
    const Result<model::StagePtr> asset = model::loadStageAsset(found);
    if (!asset) {
        fail(tr("The stage could not be read"), asset.error().message);
        return;
    }
    found.asset = asset.value();
    found.problem.clear();
    const auto edit = m_state.document().beginEdit();
    edit->changeStage(found);
    edit->commit(tr("Locate Stage"));
}

void AssetController::reportMissing()
{
    QStringList problems;
    for (const model::TemplateEntry& entry : m_state.scene().templates) {
        if (!entry.problem.empty()) {
            problems << QString::fromStdString(entry.problem);
        }
    }
    for (const model::StageEntry& entry : m_state.scene().stages) {
        if (!entry.problem.empty()) {
            problems << QString::fromStdString(entry.problem);
        }
    }
    if (problems.isEmpty()) {
        return;
    }
    auto* box = new QMessageBox(
        QMessageBox::Warning, tr("Missing Assets"),
        tr("%n asset(s) of this scene could not be loaded. The scene is intact and can be saved "
           "without loss; what they draw is not shown.",
           nullptr, static_cast<int>(problems.size())) +
            QStringLiteral("\n\n") + problems.join(QLatin1Char('\n')) + QStringLiteral("\n\n") +
            tr("To point the scene at a file that has moved, choose Locate in the Templates or the "
               "Scene panel."),
        QMessageBox::Ok, m_window);
    box->setObjectName(QStringLiteral("missingAssets"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void AssetController::fail(const QString& title, const std::string& message)
{
    auto* box = new QMessageBox(QMessageBox::Critical, title, QString::fromStdString(message),
                                QMessageBox::Ok, m_window);
    box->setObjectName(QStringLiteral("importFailure"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

} // namespace crowd::app
