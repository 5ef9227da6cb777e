// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtGui/QColor>
#include <QtWidgets/QWidget>

namespace crowd::widgets {

/// Colours as small squares, as many in a row as there is room for: a click chooses, a right click
/// asks for removal. With an addition field behind the last one if wanted.
class SwatchGrid : public QWidget
{
    Q_OBJECT

public:
    explicit SwatchGrid(int cellSize, QWidget* parent); ///< logical pixels

    void setColors(std::vector<QColor> colors);
    [[nodiscard]] const std::vector<QColor>& colors() const { return m_colors; }
    void setSelected(int index); ///< -1: none
    void setAddition(const QString& toolTip);
    /// Second line of the tool tips: what right-clicking does, what these are.
    void setHint(const QString& hint) { m_hint = hint; }
    /// Where a colour lies; behind the last one: the addition.
    [[nodiscard]] QRect cellRect(int index) const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;

Q_SIGNALS:
    void chosen(int index);
    void removalRequested(int index);
    void additionRequested();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    [[nodiscard]] int cells() const;
    [[nodiscard]] int columnsFor(int width) const;
    [[nodiscard]] int indexAt(const QPoint& point) const; ///< -1: beside them

    int m_cellSize;
    std::vector<QColor> m_colors;
    int m_selected = -1;
    QString m_additionTip; ///< empty: no addition
    QString m_hint;
};

} // namespace crowd::widgets
