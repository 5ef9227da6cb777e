// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include <QtCore/QTimer>
#include <QtWidgets/QWidget>

#include "widgets/forms/HeldEdit.h"
#include "widgets/state/EditorState.h"

class QLabel;

namespace crowd::widgets {

class FieldForm;

/// How a stage is placed, or what a camera sees: one of the scene's, or the view. What is changed
/// of a stage or a camera of the scene is an undo step; the view is not part of the scene.
class PlacementForm : public QWidget
{
    Q_OBJECT

public:
    PlacementForm(EditorState& state, QWidget* parent);

    void showStage(std::uint8_t id);
    void showCamera(const QString& name);
    void showView();
    /// What is shown may have changed, or be gone: then the view is shown.
    void refresh();
    /// The same, of cameras of the scene: the view goes along where it went along before.
    void followCameras();

private:
    [[nodiscard]] FieldForm* makeStageForm();
    [[nodiscard]] FieldForm* makeCameraForm();
    [[nodiscard]] const model::StageEntry* stage() const; ///< null: none is shown
    [[nodiscard]] const model::Camera* camera() const;    ///< of the scene; null: none is shown
    void changeStage(const std::function<void(void*)>& apply);
    void changeCamera(const std::function<void(void*)>& apply);

    EditorState& m_state;
    HeldEdit m_edit;
    std::optional<std::uint8_t> m_stageId;
    QString m_cameraName;               ///< empty: none
    std::optional<model::Camera> m_put; ///< what the view was given last
    QTimer m_soon;                      ///< the view moves often
    // Children of this widget.
    QLabel* m_title;
    FieldForm* m_stageForm;
    FieldForm* m_cameraForm;
};

} // namespace crowd::widgets
