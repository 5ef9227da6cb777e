// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtGui/QColor>

#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QGridLayout;
class QLineEdit;
class QToolButton;

namespace crowd::widgets {

class ColourSquare;

/// The colours the colour brush paints with: A and B (what a gradient runs between), a square of
/// saturation and value with a bar of hues, hex entry, and swatches of one's own.
class ColourDock : public DockBase
{
    Q_OBJECT

public:
    ColourDock(EditorState& state, QWidget* parent);

    [[nodiscard]] QColor color() const; ///< the one being edited
    void setColor(const QColor& color);

private:
    void refresh();
    void fillSwatches();
    void removeSwatch(const QColor& color);
    void loadSwatches();
    void saveSwatches() const;
    [[nodiscard]] std::size_t colorIndex() const;

    EditorState& m_state;
    ColourSquare* m_square;
    QLineEdit* m_hex;
    std::array<QToolButton*, 2> m_ends{};
    QWidget* m_swatchArea;
    QGridLayout* m_swatchGrid;
    std::vector<QColor> m_swatches;
    bool m_isSecond = false;
};

} // namespace crowd::widgets
