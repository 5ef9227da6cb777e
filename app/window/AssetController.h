// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QtCore/QObject>
#include <QtCore/QPointer>
#include <QtCore/QStringList>

#include "app/window/DialogTask.h"
#include "app/window/FoundAssets.h"
#include "model/base/Result.h"
#include "model/scene/Scene.h"
#include "widgets/state/EditorState.h"

class QDialog;

namespace crowd::widgets {
class ClipsDialog;
}

namespace crowd::app {

/// Which of several files that came together one is, from 1.
struct QueuePlace
{
    int number = 1;
    int count = 1;
};

/// Brings templates and stages into the document: import with its dialog, files dropped on the
/// window, assets that have moved. Every change is one undo step. Main thread only.
class AssetController : public QObject
{
    Q_OBJECT

public:
    AssetController(widgets::EditorState& state, QWidget* window);

    void importTemplate(); ///< asks for files
    /// Files chosen together: each has its dialog, one after the other.
    void importTemplates(const QStringList& paths);
    void addFromLibrary(); ///< asks which of the built-in cast
    void importStage();    ///< asks for a file
    /// A file from the artist's hands (dropped, or named on the command line): asks whether it is
    /// to be a template or the stage when `asks`, otherwise takes what it looks like. Of several,
    /// the answer to one may be meant for the rest.
    void bring(const QString& path, bool asks, QueuePlace place = {});
    void removeTemplate(model::TemplateId id); ///< refuses, saying so, while people use it
    void editClips(model::TemplateId id);      ///< asks for roles and speeds of its clips
    void locateTemplate(model::TemplateId id); ///< asks where a missing file is now
    void locateStage(std::uint8_t id);
    /// Names what is missing in the open scene, with ways to find it; nothing when all is there.
    void reportMissing();

    /// Without dialogs, for tests and the command line; the result comes when loading has ended.
    void addTemplate(const QString& path, const model::ImportSettings& settings,
                     const std::vector<float>& clipSpeeds = {},
                     const std::vector<std::optional<model::ClipRole>>& clipRoles = {});
    void addStage(const QString& path);
    /// Reads a missing asset from `path`, and others that are missing from near it: one undo step.
    void locateAt(const model::MissingAsset& asset, const QString& path);
    /// Reading, or a dialog of its own is open.
    [[nodiscard]] bool isBusy() const
    {
        return m_task.isRunning() || m_dialog != nullptr || !m_waiting.isEmpty();
    }
    /// Not busy, and nobody is in the middle of a stroke.
    [[nodiscard]] bool mayStart() const { return !isBusy() && !m_state.document().isEditOpen(); }

Q_SIGNALS:
    void becameIdle();
    void templateAdded(crowd::model::TemplateId id);
    void stageAdded(std::uint8_t id);

private:
    void proposeTemplate(const QString& path, QueuePlace place);
    void showProposal(const QString& path, const model::TemplatePtr& asset, QueuePlace place);
    /// Template or stage? Nothing: neither.
    [[nodiscard]] std::optional<bool> askIsStage(const QString& path, bool looksLikeStage,
                                                 QueuePlace place);
    void goOn(); ///< with what waits, once nothing runs
    void addEntries(std::vector<model::TemplateEntry> entries);
    void showClips(model::TemplateId id, const model::TemplatePtr& asset);
    void setClips(model::TemplateId id, const model::TemplatePtr& asset,
                  const widgets::ClipsDialog& dialog);
    void put(model::TemplateEntry entry, const model::TemplatePtr& asset, const QString& undoText);
    void locate(const model::MissingAsset& asset); ///< asks for the file
    void take(const FoundAssets& found);
    void fail(const QString& title, const QString& message);
    void show(QDialog* dialog); ///< without waiting; deletes itself when it is closed
    [[nodiscard]] QString askForModel(const QString& title);

    widgets::EditorState& m_state;
    QWidget* m_window;
    DialogTask m_task;
    QPointer<QDialog> m_dialog;             ///< open now
    QStringList m_waiting;                  ///< to be proposed after it
    int m_proposed = 0;                     ///< of those that wait together
    std::vector<model::TemplateId> m_batch; ///< imported with it so far
    std::optional<bool> m_restIsStage;      ///< what the rest of the files are to be
    bool m_takesProposals = false;          ///< the rest of the templates come as proposed
};

} // namespace crowd::app
