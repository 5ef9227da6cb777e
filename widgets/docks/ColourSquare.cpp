// SPDX-License-Identifier: MIT
#include "widgets/docks/ColourSquare.h"

#include <algorithm>

#include <QtGui/QLinearGradient>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>

namespace crowd::widgets {

namespace {

constexpr int kBarWidth = 18;
constexpr int kGap = 8;

double share(int position, int low, int length)
{
    return std::clamp(static_cast<double>(position - low) / std::max(1, length - 1), 0.0, 1.0);
}

} // namespace

ColourSquare::ColourSquare(QWidget* parent) : QWidget(parent)
{
    setMinimumSize(120, 72);
    setCursor(Qt::CrossCursor);
}

void ColourSquare::setColor(const QColor& color)
{
    if (color.toRgb() == this->color().toRgb()) {
        return;
    }
    if (color.hsvHueF() >= 0.0F) {
        m_hue = static_cast<double>(color.hsvHueF()); // greys keep the hue that was there
    }
    m_saturation = static_cast<double>(color.hsvSaturationF());
    m_value = static_cast<double>(color.valueF());
    update();
}

QColor ColourSquare::color() const
{
    return QColor::fromHsvF(static_cast<float>(m_hue), static_cast<float>(m_saturation),
                            static_cast<float>(m_value));
}

QRect ColourSquare::squareRect() const
{
    return rect().adjusted(0, 0, -(kBarWidth + kGap), 0);
}

QRect ColourSquare::hueRect() const
{
    return {width() - kBarWidth, 0, kBarWidth, height()};
}

void ColourSquare::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QRect square = squareRect();
    QLinearGradient saturation(square.topLeft(), square.topRight());
    saturation.setColorAt(0.0, Qt::white);
    saturation.setColorAt(1.0, QColor::fromHsvF(static_cast<float>(m_hue), 1.0F, 1.0F));
    painter.fillRect(square, saturation);
    QLinearGradient value(square.topLeft(), square.bottomLeft());
    value.setColorAt(0.0, Qt::transparent);
    value.setColorAt(1.0, Qt::black);
    painter.fillRect(square, value);
    const QRect bar = hueRect();
    QLinearGradient hues(bar.topLeft(), bar.bottomLeft());
    for (int i = 0; i <= 6; ++i) {
        const double place = i / 6.0;
        hues.setColorAt(place,
                        QColor::fromHsvF(static_cast<float>(std::min(place, 0.9999)), 1.0F, 1.0F));
    }
    painter.fillRect(bar, hues);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF spot(square.left() + m_saturation * (square.width() - 1),
                       square.top() + (1.0 - m_value) * (square.height() - 1));
    const double hueY = bar.top() + m_hue * (bar.height() - 1);
    for (const auto& [color, width] :
         {std::pair{QColor(0, 0, 0, 160), 3.0}, {QColor(Qt::white), 1.5}}) {
        painter.setPen(QPen(color, width));
        painter.drawEllipse(spot, 5.0, 5.0);
        painter.drawLine(QPointF(bar.left(), hueY), QPointF(bar.right() + 1, hueY));
    }
}

void ColourSquare::mousePressEvent(QMouseEvent* event)
{
    m_isOnHue = event->pos().x() > squareRect().right() + kGap / 2;
    pick(event->pos());
}

void ColourSquare::mouseMoveEvent(QMouseEvent* event)
{
    pick(event->pos());
}

void ColourSquare::pick(const QPoint& point)
{
    if (m_isOnHue) {
        m_hue = std::min(share(point.y(), hueRect().top(), hueRect().height()), 0.9999);
    } else {
        const QRect square = squareRect();
        m_saturation = share(point.x(), square.left(), square.width());
        m_value = 1.0 - share(point.y(), square.top(), square.height());
    }
    update();
    Q_EMIT colorPicked(color());
}

} // namespace crowd::widgets
