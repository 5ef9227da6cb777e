// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QWidget>

#include "widgets/state/EditorState.h"

class QSlider;

namespace crowd::widgets {

/// The scene's light: where the sun stands and how strong sun and sky are. One drag of a slider is
/// one undo step.
class LightForm : public QWidget
{
    Q_OBJECT

public:
    LightForm(EditorState& state, QWidget* parent);
    ~LightForm() override;

private:
    QSlider* addSlider(const QString& label, int low, int high, float model::Lighting::*value,
                       float scale);
    void refresh();

    struct Row
    {
        QSlider* slider;
        float model::Lighting::*value;
        float scale; ///< value of one slider step
    };

    EditorState& m_state;
    std::vector<Row> m_rows;
    std::unique_ptr<model::SceneEdit> m_edit; ///< while a slider is held
    bool m_isFilling = false;
};

} // namespace crowd::widgets
