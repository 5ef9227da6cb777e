// SPDX-License-Identifier: MIT
#include "widgets/forms/CurveEditor.h"

#include <algorithm>

#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>

namespace crowd::widgets {

CurveEditor::CurveEditor(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::CrossCursor);
}

void CurveEditor::setCurve(const model::DistributionCurve& curve)
{
    m_curve = curve;
    update();
}

void CurveEditor::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    QColor bar = palette().color(QPalette::Highlight);
    bar.setAlphaF(isEnabled() ? 0.7F : 0.2F);
    const double bin =
        static_cast<double>(width() - 4) / static_cast<double>(m_curve.weights.size());
    for (std::size_t i = 0; i < m_curve.weights.size(); ++i) {
        const double tall = static_cast<double>(m_curve.weights[i]) * (height() - 6);
        painter.fillRect(
            QRectF(2.0 + static_cast<double>(i) * bin, height() - 2 - tall, bin - 1.0, tall), bar);
    }
}

int CurveEditor::binAt(double x) const
{
    const auto count = static_cast<int>(m_curve.weights.size());
    return std::clamp(static_cast<int>((x - 2.0) * count / (width() - 4)), 0, count - 1);
}

void CurveEditor::drawTo(const QPointF& point)
{
    const int bin = binAt(point.x());
    const auto weight =
        static_cast<float>(std::clamp(1.0 - (point.y() - 3.0) / (height() - 6.0), 0.0, 1.0));
    // Quick hands skip bins: the way between is filled.
    const int step = bin >= m_lastBin ? 1 : -1;
    const int way = std::abs(bin - m_lastBin);
    for (int i = 0; i <= way; ++i) {
        const float share = way == 0 ? 1.0F : static_cast<float>(i) / static_cast<float>(way);
        const int passed = m_lastBin + i * step;
        m_curve.weights[static_cast<std::size_t>(passed)] =
            m_lastWeight + (weight - m_lastWeight) * share;
    }
    m_lastBin = bin;
    m_lastWeight = weight;
    update();
    Q_EMIT edited();
}

void CurveEditor::mousePressEvent(QMouseEvent* event)
{
    m_lastBin = binAt(event->position().x());
    m_lastWeight = static_cast<float>(
        std::clamp(1.0 - (event->position().y() - 3.0) / (height() - 6.0), 0.0, 1.0));
    drawTo(event->position());
}

void CurveEditor::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons().testFlag(Qt::LeftButton)) {
        drawTo(event->position());
    }
}

void CurveEditor::mouseDoubleClickEvent(QMouseEvent*)
{
    m_curve = {};
    update();
    Q_EMIT edited();
}

} // namespace crowd::widgets
