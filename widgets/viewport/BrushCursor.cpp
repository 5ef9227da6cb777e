// SPDX-License-Identifier: MIT
#include "widgets/viewport/BrushCursor.h"

#include <algorithm>
#include <cmath>

#include <QtGui/QPainter>

#include "widgets/viewport/ToolIcons.h"

namespace crowd::widgets {

namespace {

constexpr int kPlateSize = 26;
constexpr double kPlateGap = 9.0;
constexpr double kCrossArm = 5.0;

const QColor kPenDark = QColor::fromRgba(kOverlayDark);
const QColor kPenLight = QColor::fromRgba(kOverlayLight);

} // namespace

QPixmap brushSymbol(ToolId tool, double devicePixelRatio)
{
    return toolSymbol(tool, kPlateSize - 6, devicePixelRatio);
}

void paintBrushArea(QPainter& painter, const ToolPicture& picture)
{
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(kPenDark, 3.0), QPen(kPenLight, 1.0)}) {
        painter.setPen(pen);
        if (picture.circle) {
            painter.drawEllipse(picture.circle->center, picture.circle->radius,
                                picture.circle->radius);
        }
        if (picture.crosshair) {
            const QPointF at = *picture.crosshair;
            painter.drawLine(at - QPointF(kCrossArm, 0.0), at + QPointF(kCrossArm, 0.0));
            painter.drawLine(at - QPointF(0.0, kCrossArm), at + QPointF(0.0, kCrossArm));
        }
    }
}

void paintBrushSymbol(QPainter& painter, const ToolPicture& picture, const QPixmap& symbol,
                      const QRectF& area)
{
    if (!picture.symbol || symbol.isNull()) {
        return;
    }
    QPointF corner = picture.symbolAt + QPointF(kPlateGap, kPlateGap);
    if (corner.x() + kPlateSize > area.right()) {
        corner.setX(picture.symbolAt.x() - kPlateGap - kPlateSize);
    }
    if (corner.y() + kPlateSize > area.bottom()) {
        corner.setY(picture.symbolAt.y() - kPlateGap - kPlateSize);
    }
    const QRectF plate(corner, QSizeF(kPlateSize, kPlateSize));
    painter.setPen(QPen(kPenDark, 1.0));
    painter.setBrush(QColor(250, 250, 250, 225));
    painter.drawRoundedRect(plate, 5.0, 5.0);
    painter.drawPixmap(plate.topLeft() + QPointF(3.0, 3.0), symbol);
    painter.setBrush(Qt::NoBrush);
}

std::optional<QCursor> BrushCursor::cursorFor(const ToolPicture& picture, double devicePixelRatio)
{
    const bool isPoint = picture.crosshair.has_value() && !picture.circle;
    const double radius = isPoint ? 0.0 : picture.circle ? picture.circle->radius : -1.0;
    if (radius < 0.0 || radius > kLargestRadius) {
        return std::nullopt;
    }
    if (radius == m_radius && devicePixelRatio == m_ratio && m_tool == picture.symbol) {
        return m_cursor;
    }
    m_radius = radius;
    m_ratio = devicePixelRatio;
    m_tool = picture.symbol;
    const int half =
        static_cast<int>(std::ceil(std::max(radius + 3.0, kPlateGap + kPlateSize + 2.0)));
    QPixmap pixmap(QSize(2 * half + 1, 2 * half + 1) * devicePixelRatio);
    pixmap.setDevicePixelRatio(devicePixelRatio);
    pixmap.fill(Qt::transparent);
    const QPointF center(half + 0.5, half + 0.5);
    ToolPicture drawn = picture;
    drawn.symbolAt = center;
    drawn.crosshair = center; // the exact point, as the cursor that this one takes the place of
    if (drawn.circle) {
        drawn.circle->center = center;
    }
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    paintBrushArea(painter, drawn);
    paintBrushSymbol(painter, drawn, m_tool ? brushSymbol(*m_tool, devicePixelRatio) : QPixmap(),
                     QRectF(0.0, 0.0, 2.0 * half + 1.0, 2.0 * half + 1.0));
    painter.end();
    m_cursor = QCursor(pixmap, half, half);
    return m_cursor;
}

} // namespace crowd::widgets
