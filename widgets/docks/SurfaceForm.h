// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QWidget>

#include "widgets/state/EditorState.h"

class QCheckBox;
class QLabel;
class QToolButton;

namespace crowd::widgets {

class NumberField;

/// What people can walk on: how wide and tall they are, how steep and high they climb, and what
/// has become of it. Folded away until it is wanted; every change is one undo step.
class SurfaceForm : public QWidget
{
    Q_OBJECT

public:
    SurfaceForm(EditorState& state, QWidget* parent);

private:
    void setUpShown();
    void addField(const QString& label, const QString& tip, const char* name,
                  float model::SurfaceSettings::*member, double low, double high);
    void refresh();
    void showState();

    struct Field
    {
        NumberField* widget;
        float model::SurfaceSettings::*member;
    };

    EditorState& m_state;
    std::vector<Field> m_fields;
    // Children of this widget.
    QToolButton* m_fold;
    QWidget* m_rows;
    QCheckBox* m_shown;
    QLabel* m_note;
};

} // namespace crowd::widgets
