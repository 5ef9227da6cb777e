// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <QtCore/QTimer>
#include <QtWidgets/QDialog>

#include "model/bake/KeyframeStore.h"
#include "model/gltf/ImportProposal.h"
#include "model/scene/Scene.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QTableWidget;

namespace crowd::widgets {

class TemplatePreview;

/// Shows what was found in a foreign character and how it will stand in the scene: proposes scale,
/// up-axis, facing and ground offset, lets the artist change them with a live preview, and edit the
/// ground speed of each clip. Owns nothing of the document. Main thread.
class ImportDialog : public QDialog
{
    Q_OBJECT

public:
    /// `asset` was imported with default settings.
    ImportDialog(const QString& path, model::TemplatePtr asset, model::KeyframeStore& keyframes,
                 QWidget* parent);
    ~ImportDialog() override;

    [[nodiscard]] model::ImportSettings settings() const;
    /// One per clip, NaN where the file's own speed stands; empty when none was edited.
    [[nodiscard]] std::vector<float> clipSpeeds() const;

private:
    void buildForm();
    void buildClips();
    void refresh();
    [[nodiscard]] glm::quat rotation() const;

    QString m_path;
    model::TemplatePtr m_asset;
    model::ImportProposal m_proposal;
    TemplatePreview* m_preview;
    QDoubleSpinBox* m_scale;
    QComboBox* m_upAxis;
    QDoubleSpinBox* m_turn;
    QDoubleSpinBox* m_groundOffset;
    QCheckBox* m_rootMotion;
    QLabel* m_height;
    QTableWidget* m_clips;
    QTimer m_refresh;
};

} // namespace crowd::widgets
