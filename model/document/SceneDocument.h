// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include <QtCore/QObject>
#include <QtCore/QString>
#include <QtGui/QUndoStack>

#include "model/base/Result.h"
#include "model/document/EarlierPeople.h"
#include "model/document/UndoMemory.h"
#include "model/scene/CrowdFrame.h"
#include "model/scene/Scene.h"
#include "model/scene/SceneChange.h"

namespace crowd::model {

class SceneEdit;
class StoredDelta;
struct ChangeOver;
enum class DeltaDirection;
struct RecordedStroke;
struct SceneDelta;

enum class EditOutcome : std::uint8_t {
    Committed, ///< one undo step
    Unchanged, ///< nothing changed in the end: no step
    Refused    ///< another edit is open: nothing was done
};

/// An edit became an undo step.
struct StepCommitted
{
    const SceneDelta* delta = nullptr;
    QString text;
    const RecordedStroke* stroke = nullptr; ///< that made it; null: it was no stroke
};

/// The open document: owns the scene with its undo stack, path and modified flag. Reading is free;
/// writing goes through SceneEdit, whose commit() makes one undo step. Steps that exceed the memory
/// for undo go to a temporary file. An undo or redo that cannot be done (its step cannot be read
/// back, or an edit is open) is refused: scene and stack stay as they were. Main thread only.
class SceneDocument : public QObject
{
    Q_OBJECT

public:
    explicit SceneDocument(UndoLimits limits = {}, QObject* parent = nullptr);
    ~SceneDocument() override;

    [[nodiscard]] const Scene& scene() const { return m_scene; }
    [[nodiscard]] QUndoStack& undoStack() { return m_undoStack; }
    [[nodiscard]] const QUndoStack& undoStack() const { return m_undoStack; }
    [[nodiscard]] QString path() const { return m_path; } ///< empty: never saved
    [[nodiscard]] bool isModified() const { return !m_undoStack.isClean(); }
    /// Grows with every change of the scene; never the same for two states.
    [[nodiscard]] std::uint64_t revision() const { return m_revision; }
    [[nodiscard]] const UndoMemory& undoMemory() const { return m_undoMemory; }
    /// Takes effect at once; all steps are kept.
    void setUndoBudget(std::size_t bytes);
    /// Memory that others keep for the sake of its steps; the budget includes it.
    void countBesideUndo(std::size_t bytes);

    /// Takes another scene (New, Open); clears the undo stack and interrupts an open edit.
    void replaceScene(Scene scene, const QString& path);
    /// After a successful save.
    void markSaved(const QString& path);

    [[nodiscard]] const EarlierPeople& earlierPeople() const { return m_earlier; }
    /// People as they are now are what EarlierPeople::before says.
    void rememberPeople() { m_earlier.before = m_scene.population; }

    /// Does `work` as one undo step of this text, or as none where nothing changes. Refused while
    /// another edit is open: the work is not done, and editRefused() says why.
    EditOutcome edit(const QString& text, const std::function<void(SceneEdit&)>& work);
    /// The same with a text that the work knows in the end.
    EditOutcome edit(const std::function<QString(SceneEdit&)>& work);
    /// For an edit that goes on, as a drag does. One at a time: refused as above.
    [[nodiscard]] Result<std::unique_ptr<SceneEdit>> beginEdit();
    [[nodiscard]] bool isEditOpen() const { return m_openEdit != nullptr; }
    /// Asks whoever holds an open edit to drop it, which takes it back.
    void interruptEdit();

    /// Snapshot for the given transport time.
    [[nodiscard]] CrowdFramePtr frame(double seconds) const;

Q_SIGNALS:
    void changed(const crowd::model::SceneChange& change);
    /// People are about to have other values, in the edit that is open: who shows the scene as it
    /// plays lets them change over to these. Undone and done again, they change at once.
    void changingOver(const crowd::model::ChangeOver& change);
    /// The scene is changed; the undo stack gets its step next.
    void stepCommitted(const crowd::model::StepCommitted& step);
    /// A step was undone (or done again); the undo stack moves its index next.
    void stepTaken(bool isUndo);
    void pathChanged();
    void modifiedChanged(bool isModified);
    /// An edit was not done since another is open; `why` is for the artist. Nothing has changed.
    void editRefused(const QString& why);
    /// Holders of an open edit destroy it now.
    void editInterrupted();
    /// An undo or redo could not be done; `why` is for the artist. Nothing has changed.
    void undoRefused(const QString& why);
    void undoBudgetChanged();
    /// Undo steps cannot go to disk any more and take more memory than they should; said once.
    void undoMemoryExceeded(const QString& why);

private:
    friend class SceneEdit;
    friend class SceneCommand;

    void announce(const SceneChange& change);
    void push(SceneDelta delta, const QString& text, const RecordedStroke* stroke);
    /// False: refused, and so are all further steps of the same move along the stack.
    [[nodiscard]] bool applyStep(StoredDelta& stored, DeltaDirection direction);
    void settleRefusal();
    void noteCreated(const SceneDelta& delta);
    void watchUndoMemory();

    Scene m_scene;
    UndoMemory m_undoMemory; ///< outlives the stack, whose commands are kept in it
    QUndoStack m_undoStack;
    std::optional<QString> m_refusal; ///< why the current move along the stack has ended
    bool m_isMemoryExceeded = false;
    std::uint64_t m_revision = 0;
    QString m_path;
    EarlierPeople m_earlier;
    SceneEdit* m_openEdit = nullptr;
    mutable std::shared_ptr<const std::vector<TemplateEntry>> m_sharedTemplates;
};

} // namespace crowd::model
