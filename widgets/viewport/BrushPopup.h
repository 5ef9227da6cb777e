// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtWidgets/QFrame>

#include "widgets/state/EditorState.h"

class QButtonGroup;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace crowd::widgets {

/// The brush palette at the cursor: choose a tool, one of the presets and colours of late, the
/// brush's area, its size and its main number without leaving the picture. Choosing a tool or a
/// preset closes it; so do a click elsewhere and Escape.
class BrushPopup : public QFrame
{
    Q_OBJECT

public:
    explicit BrushPopup(EditorState& state, QWidget* parent);

    /// With the tool in hand under the pointer, so that nothing changes by a second click; kept on
    /// the screen.
    void popUp(const QPoint& globalPosition);

private:
    QWidget* makeTools();
    void fillPresets();
    void fillColours();
    void paintWith(const QColor& color);
    QWidget* makeSettings();
    void refresh();
    void refreshSettings(const model::BrushSettings& brush);
    void change(const std::function<model::BrushSettings(const model::BrushSettings&)>& how);

    EditorState& m_state;
    // Children of this widget.
    QWidget* m_toolGrid = nullptr;
    QButtonGroup* m_tools = nullptr;
    QWidget* m_presets = nullptr; ///< those of late; hidden while there are none
    QWidget* m_colours = nullptr; ///< of the colour brush
    QWidget* m_settings = nullptr;
    QLabel* m_selectionText = nullptr;
    QComboBox* m_selection = nullptr;
    QLabel* m_sizeTitle = nullptr;
    QSlider* m_size = nullptr;
    QLabel* m_sizeText = nullptr;
    QLabel* m_numberText = nullptr;
    QDoubleSpinBox* m_number = nullptr;
    bool m_isRefreshing = false;
};

} // namespace crowd::widgets
