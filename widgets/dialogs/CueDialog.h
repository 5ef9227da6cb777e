// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QDialog>

#include "model/scene/Scene.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;

namespace crowd::widgets {

/// What a cue is called, which event it sends with which number, by which key and to whom.
class CueDialog : public QDialog
{
    Q_OBJECT

public:
    CueDialog(const model::Scene& scene, const model::Cue& cue, QWidget* parent);
    /// As it was edited.
    [[nodiscard]] model::Cue cue() const;

private:
    void fillKeys(const model::Scene& scene);
    void showReach();

    model::Cue m_cue;
    // Children of this widget.
    QFormLayout* m_form;
    QLineEdit* m_name;
    QComboBox* m_event;
    QDoubleSpinBox* m_payload;
    QComboBox* m_key;
    QComboBox* m_reach;
    QComboBox* m_tag;
};

} // namespace crowd::widgets
