// SPDX-License-Identifier: MIT
#include "widgets/docks/SwatchGrid.h"

#include <algorithm>

#include <QtGui/QHelpEvent>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>
#include <QtWidgets/QToolTip>

namespace crowd::widgets {

namespace {

constexpr int kCellGap = 3;
constexpr int kLeastColumns = 4;

} // namespace

SwatchGrid::SwatchGrid(int cellSize, QWidget* parent) : QWidget(parent), m_cellSize(cellSize)
{
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void SwatchGrid::setColors(std::vector<QColor> colors)
{
    if (m_colors == colors) {
        return;
    }
    m_colors = std::move(colors);
    updateGeometry();
    update();
}

void SwatchGrid::setSelected(int index)
{
    m_selected = index;
    update();
}

void SwatchGrid::setAddition(const QString& toolTip)
{
    m_additionTip = toolTip;
    updateGeometry();
}

int SwatchGrid::cells() const
{
    return static_cast<int>(m_colors.size()) + (m_additionTip.isEmpty() ? 0 : 1);
}

int SwatchGrid::columnsFor(int width) const
{
    return std::max(kLeastColumns, (width + kCellGap) / (m_cellSize + kCellGap));
}

int SwatchGrid::heightForWidth(int width) const
{
    const int columns = columnsFor(width);
    const int rows = std::max(1, (cells() + columns - 1) / columns);
    return rows * (m_cellSize + kCellGap) - kCellGap;
}

QSize SwatchGrid::sizeHint() const
{
    return {10 * (m_cellSize + kCellGap), heightForWidth(width())};
}

/// What it is in would go on with the height that it asked for while it was narrow.
void SwatchGrid::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (heightForWidth(event->oldSize().width()) != heightForWidth(width())) {
        updateGeometry();
    }
}

QSize SwatchGrid::minimumSizeHint() const
{
    return {kLeastColumns * (m_cellSize + kCellGap), m_cellSize};
}

QRect SwatchGrid::cellRect(int index) const
{
    const int columns = columnsFor(width());
    const int pitch = m_cellSize + kCellGap;
    return {index % columns * pitch, index / columns * pitch, m_cellSize, m_cellSize};
}

int SwatchGrid::indexAt(const QPoint& point) const
{
    for (int index = 0; index < cells(); ++index) {
        if (cellRect(index).contains(point)) {
            return index;
        }
    }
    return -1;
}

void SwatchGrid::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    for (int index = 0; index < cells(); ++index) {
        const QRect cell = cellRect(index).adjusted(0, 0, -1, -1);
        if (index == static_cast<int>(m_colors.size())) {
            painter.setPen(QPen(palette().color(QPalette::ButtonText), 1.0));
            const QPoint middle = cell.center();
            const int arm = m_cellSize / 4;
            painter.drawLine(middle - QPoint(arm, 0), middle + QPoint(arm, 0));
            painter.drawLine(middle - QPoint(0, arm), middle + QPoint(0, arm));
            painter.setPen(QPen(palette().color(QPalette::Mid), 1.0, Qt::DotLine));
            painter.setBrush(Qt::NoBrush);
            painter.drawRect(cell);
            continue;
        }
        painter.setBrush(m_colors[static_cast<std::size_t>(index)]);
        painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
        painter.drawRect(cell);
        if (index == m_selected) {
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(palette().color(QPalette::Base), 1.0));
            painter.drawRect(cell.adjusted(2, 2, -2, -2));
            painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
            painter.drawRect(cell.adjusted(1, 1, 0, 0));
        }
    }
}

void SwatchGrid::mousePressEvent(QMouseEvent* event)
{
    const int index = indexAt(event->position().toPoint());
    if (index < 0) {
        return;
    }
    const bool isAddition = index == static_cast<int>(m_colors.size());
    if (event->button() == Qt::LeftButton) {
        isAddition ? Q_EMIT additionRequested() : Q_EMIT chosen(index);
    } else if (event->button() == Qt::RightButton && !isAddition) {
        Q_EMIT removalRequested(index);
    }
}

bool SwatchGrid::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip) {
        return QWidget::event(event);
    }
    auto* help = static_cast<QHelpEvent*>(event);
    const int index = indexAt(help->pos());
    if (index < 0) {
        QToolTip::hideText();
    } else if (index == static_cast<int>(m_colors.size())) {
        QToolTip::showText(help->globalPos(), m_additionTip, this);
    } else {
        const QString name = m_colors[static_cast<std::size_t>(index)].name();
        QToolTip::showText(help->globalPos(),
                           m_hint.isEmpty() ? name : QStringLiteral("%1\n%2").arg(name, m_hint),
                           this);
    }
    return true;
}

} // namespace crowd::widgets
