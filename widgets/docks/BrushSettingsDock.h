// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QtCore/QTimer>
#include <QtWidgets/QLabel>

#include "widgets/docks/BrushForm.h"
#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

namespace crowd::widgets {

/// How the active brush is set: selection, size, rate, operator, and what it changes. Of a tool
/// that has nothing to set, what it does.
class BrushSettingsDock : public DockBase
{
    Q_OBJECT

public:
    BrushSettingsDock(EditorState& state, QWidget* parent);

private:
    void rebuild();
    void sayWhatItDoes();

    EditorState& m_state;
    FieldForm* m_form = nullptr; ///< null while no brush is active
    QLabel* m_note = nullptr;    ///< null while a brush is active
    QTimer m_rebuild;
};

} // namespace crowd::widgets
