// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtWidgets/QWidget>

#include "widgets/docks/SelectedPeople.h"
#include "widgets/state/EditorState.h"

class QComboBox;
class QFormLayout;

namespace crowd::widgets {

/// What those who are selected are like: a choice for each kind of feature of the scene. Main
/// thread.
class FeatureRows : public QWidget
{
    Q_OBJECT

public:
    FeatureRows(EditorState& state, QWidget* parent);

    void refresh(const SelectedPeople& selected);

private:
    struct Row
    {
        std::uint8_t kind;
        QComboBox* box;
    };
    void rebuild();

    EditorState& m_state;
    QFormLayout* m_form;
    model::FeatureKinds m_builtFor;
    std::vector<Row> m_rows;
};

} // namespace crowd::widgets
