// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtGui/QColor>

#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QLabel;
class QLineEdit;
class QToolButton;

namespace crowd::widgets {

class ColourSquare;
class SwatchGrid;

/// The colours that the colour brush paints with (a gradient runs through them from first to last),
/// or, while the create brush is active, those that new people wear: a square of saturation and
/// value with a bar of hues, hex entry, a dropper, the colours painted last, and swatches of one's
/// own.
class ColourDock : public DockBase
{
    Q_OBJECT

public:
    ColourDock(EditorState& state, QWidget* parent);

    [[nodiscard]] QColor color() const; ///< the one being edited
    void setColor(const QColor& color);

protected:
    void changeEvent(QEvent* event) override;

private:
    void connectState();
    void refresh();
    void refreshIcons();
    [[nodiscard]] bool paintsFirst() const; ///< the first colour alone
    void choose(int index);
    void bringChosenFirst();
    void addColor();
    void removeColor(int index);
    void pick();
    void noteUsed(model::BrushKind kind);
    void keepSwatch();
    void removeSwatch(int index);
    /// The brush whose colours are shown, and where they are kept in its settings.
    [[nodiscard]] model::BrushKind kind() const;
    [[nodiscard]] std::vector<model::PaintColor>& colorsOf(model::BrushSettings& brush) const;
    [[nodiscard]] std::vector<QColor> colors() const;

    EditorState& m_state;
    SwatchGrid* m_chips;
    ColourSquare* m_square;
    QToolButton* m_dropper;
    QLineEdit* m_hex;
    SwatchGrid* m_recent;
    SwatchGrid* m_swatches;
    QLabel* m_ofWhom;         ///< while the colours are of new characters
    std::size_t m_chosen = 0; ///< which of the brush's colours is edited
};

} // namespace crowd::widgets
