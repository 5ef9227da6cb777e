// SPDX-License-Identifier: MIT
#include "widgets/theme/CrowdStyle.h"

#include <algorithm>

#include <QtGui/QPainter>
#include <QtWidgets/QStyleOption>

namespace crowd::widgets {

namespace {

constexpr int kFrameAlpha = 150; ///< of 255
constexpr int kTabSpace = 12;    ///< beside a tab's text; half of Fusion's
constexpr int kPanelEdge = 4;    ///< logical pixels, to be grasped

QColor between(const QColor& a, const QColor& b, double t)
{
    const auto part = [t](int from, int to) { return from + qRound((to - from) * t); };
    return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

/// Frame and ground of an indicator; returns the colour of the mark on it.
QColor paintGround(QPainter& painter, const QRectF& box, const QStyleOption& option, bool isRound)
{
    const bool isOn = (option.state & (QStyle::State_On | QStyle::State_NoChange)) != 0;
    const bool isEnabled = (option.state & QStyle::State_Enabled) != 0;
    const QPalette& palette = option.palette;
    const QColor ground = palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::Active, QPalette::Text);
    const QColor accent = isEnabled ? palette.color(QPalette::Active, QPalette::Highlight)
                                    : between(ground, text, 0.35);
    const bool isHovered = isEnabled && (option.state & QStyle::State_MouseOver) != 0;
    const QColor frame = isOn || isHovered ? accent : between(ground, text, isEnabled ? 0.5 : 0.25);
    painter.setPen(QPen(frame, 1.0));
    painter.setBrush(isOn ? accent : ground);
    const double radius = isRound ? box.width() / 2.0 : 2.5;
    painter.drawRoundedRect(box, radius, radius);
    return isEnabled ? palette.color(QPalette::Active, QPalette::HighlightedText) : ground;
}

void paintCheck(QPainter& painter, const QRectF& box, const QColor& color)
{
    const auto at = [&](double x, double y) {
        return box.topLeft() + QPointF(x * box.width(), y * box.height());
    };
    painter.setPen(QPen(color, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    const QPointF way[]{at(0.24, 0.54), at(0.43, 0.73), at(0.78, 0.29)};
    painter.drawPolyline(way, 3);
}

void paintDash(QPainter& painter, const QRectF& box, const QColor& color)
{
    painter.setPen(QPen(color, 1.8, Qt::SolidLine, Qt::RoundCap));
    const double middle = box.center().y();
    painter.drawLine(QPointF(box.left() + 3.5, middle), QPointF(box.right() - 3.5, middle));
}

} // namespace

CrowdStyle::CrowdStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

void CrowdStyle::polish(QWidget* widget)
{
    QProxyStyle::polish(widget);
    m_wheel.watch(*widget);
}

void CrowdStyle::unpolish(QWidget* widget)
{
    m_wheel.forget(*widget);
    QProxyStyle::unpolish(widget);
}

int CrowdStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
                            const QWidget* widget) const
{
    switch (metric) {
    case PM_TabBarTabHSpace:
        return kTabSpace;
    case PM_DockWidgetFrameWidth: // of floating ones: they are made larger by it
        return kPanelEdge;
    default:
        return QProxyStyle::pixelMetric(metric, option, widget);
    }
}

void CrowdStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                               QPainter* painter, const QWidget* widget) const
{
    if (element == PE_FrameDockWidget) { // a floating panel has no other edge
        QColor edge = option->palette.color(QPalette::WindowText);
        edge.setAlpha(kFrameAlpha);
        painter->setPen(edge);
        painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
        return;
    }
    const bool isRound = element == PE_IndicatorRadioButton;
    if (!isRound && element != PE_IndicatorCheckBox && element != PE_IndicatorItemViewItemCheck) {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        return;
    }
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const double side = std::min(option->rect.width(), option->rect.height()) - 1.0;
    QRectF box(0.0, 0.0, side, side);
    box.moveCenter(QRectF(option->rect).center());
    const QColor mark = paintGround(*painter, box, *option, isRound);
    if (isRound && (option->state & State_On) != 0) {
        painter->setPen(Qt::NoPen);
        painter->setBrush(mark);
        painter->drawEllipse(box.center(), side * 0.2, side * 0.2);
    } else if ((option->state & State_On) != 0) {
        paintCheck(*painter, box, mark);
    } else if ((option->state & State_NoChange) != 0) {
        paintDash(*painter, box, mark);
    }
    painter->restore();
}

} // namespace crowd::widgets
