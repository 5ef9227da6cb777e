// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <QtCore/QTimer>
#include <QtWidgets/QDialog>

#include "model/bake/KeyframeStore.h"
#include "model/base/Result.h"
#include "model/gltf/ImportProposal.h"
#include "model/scene/Scene.h"
#include "widgets/tasks/BackgroundTask.h"

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace crowd::widgets {

class ClipTable;
class TemplatePreview;

/// Shows what was found in a foreign character and how it will stand in the scene: proposes scale,
/// up-axis, facing and ground offset, lets the artist change them with a live preview, and edit the
/// ground speed and the role of each clip. Imports again on a thread of its own, so that it stays
/// at hand whatever the size of the file. Owns nothing of the document. Main thread.
class ImportDialog : public QDialog
{
    Q_OBJECT

public:
    /// `asset` was imported with default settings.
    ImportDialog(const QString& path, model::TemplatePtr asset, model::KeyframeStore& keyframes,
                 QWidget* parent);

    [[nodiscard]] model::ImportSettings settings() const;
    /// One per clip, NaN where the file's own speed stands; empty when none was edited.
    [[nodiscard]] std::vector<float> clipSpeeds() const;
    /// One per clip, nothing where the proposed role stands; empty when none was chosen.
    [[nodiscard]] std::vector<std::optional<model::ClipRole>> clipRoles() const;
    /// More files are to come after this one: a button takes them all as they are proposed.
    void offerRest(int count);
    /// It was pressed.
    [[nodiscard]] bool isForRest() const { return m_isForRest; }
    /// The preview shows the present settings.
    [[nodiscard]] bool isSettled() const { return !m_task.isRunning() && !m_refresh.isActive(); }

private:
    void buildLayout();
    [[nodiscard]] QString remarks() const;
    void propose();
    void refresh();
    void take(const model::Result<model::TemplatePtr>& asset,
              const model::ImportSettings& settings);
    void scaleToHeight(double metres);
    void putOnGround();
    [[nodiscard]] glm::quat rotation() const;

    QString m_path;
    model::TemplatePtr m_asset;    ///< as it was imported last
    model::ImportSettings m_shown; ///< with these settings
    model::ImportProposal m_proposal;
    BackgroundTask m_task; ///< the import with the settings that were asked for last
    QTimer m_refresh;
    // Children of this widget.
    TemplatePreview* m_preview;
    QDoubleSpinBox* m_scale;
    QDoubleSpinBox* m_height;
    QComboBox* m_upAxis;
    QDoubleSpinBox* m_turn;
    QDoubleSpinBox* m_groundOffset;
    QCheckBox* m_rootMotion;
    QLabel* m_remarks;
    ClipTable* m_clips;
    QPushButton* m_import = nullptr;
    QPushButton* m_importAll = nullptr; ///< where more files are to come
    QDialogButtonBox* m_buttons = nullptr;
    bool m_isForRest = false;
};

} // namespace crowd::widgets
