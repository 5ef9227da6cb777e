// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QWidget>

#include "widgets/state/EditorState.h"

class QCheckBox;

namespace crowd::widgets {

class FieldForm;

/// How states are given back: EditorState::recall(), kept for the next start. Main thread.
class RecallForm : public QWidget
{
    Q_OBJECT

public:
    RecallForm(EditorState& state, QWidget* parent);

private:
    void addTiming();
    void addReach();
    [[nodiscard]] QCheckBox* addTick(const char* name, bool RecallSettings::*member);
    void keep(const RecallSettings& recall);

    EditorState& m_state;
    FieldForm* m_timing = nullptr;
    QCheckBox* m_isForRun = nullptr;
    QCheckBox* m_isForSelected = nullptr;
};

} // namespace crowd::widgets
