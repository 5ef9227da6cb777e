// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <QtCore/QObject>
#include <QtCore/QString>
#include <QtGui/QUndoStack>

#include "model/document/SceneChange.h"
#include "model/scene/CrowdFrame.h"
#include "model/scene/Scene.h"

namespace crowd::model {

class SceneEdit;

/// The open document: owns the scene with its undo stack, path and modified flag. Reading is free;
/// writing goes through SceneEdit, whose commit() makes one undo step. Main thread only.
class SceneDocument : public QObject
{
    Q_OBJECT

public:
    explicit SceneDocument(QObject* parent = nullptr);
    ~SceneDocument() override;

    [[nodiscard]] const Scene& scene() const { return m_scene; }
    [[nodiscard]] QUndoStack& undoStack() { return m_undoStack; }
    [[nodiscard]] const QUndoStack& undoStack() const { return m_undoStack; }
    [[nodiscard]] QString path() const { return m_path; } ///< empty: never saved
    [[nodiscard]] bool isModified() const { return !m_undoStack.isClean(); }

    /// Takes another scene (New, Open); clears the undo stack.
    void replaceScene(Scene scene, const QString& path);
    /// After a successful save.
    void markSaved(const QString& path);
    /// Puts a loaded asset (or the reason why it is not there) into its entry: not an edit, not
    /// undoable.
    void setTemplateAsset(TemplateId id, TemplatePtr asset, const std::string& problem);
    void setStageAsset(std::uint8_t id, StagePtr asset, const std::string& problem);

    /// Starts an edit. One at a time: asserts when another is open.
    [[nodiscard]] std::unique_ptr<SceneEdit> beginEdit();
    [[nodiscard]] bool isEditOpen() const { return m_openEdit != nullptr; }

    /// Snapshot for the given transport time.
    [[nodiscard]] CrowdFramePtr frame(double seconds) const;

Q_SIGNALS:
    void changed(const crowd::model::SceneChange& change);
    void pathChanged();
    void modifiedChanged(bool isModified);

private:
    friend class SceneEdit;
    friend class SceneCommand;

    void announce(const SceneChange& change);

    Scene m_scene;
    QUndoStack m_undoStack;
    QString m_path;
    SceneEdit* m_openEdit = nullptr;
    mutable std::shared_ptr<const std::vector<TemplateEntry>> m_sharedTemplates;
};

} // namespace crowd::model

Q_DECLARE_METATYPE(crowd::model::SceneChange)
