// SPDX-License-Identifier: MIT
#include "widgets/viewport/ViewportOverlay.h"

#include <algorithm>

#include <QtGui/QPainter>
#include <QtGui/QPainterPath>

#include "widgets/viewport/LabelLayout.h"
#include "widgets/viewport/ToolIcons.h"

namespace crowd::widgets {

namespace {

constexpr int kSymbolSize = 26;
constexpr double kSymbolGap = 9.0;
constexpr double kCrosshair = 5.0;
constexpr double kTarget = 8.0;

const QColor kDark(0, 0, 0, 170);
const QColor kLight(255, 255, 255, 235);
const QColor kAccent(255, 170, 60);

/// Light on dark, so that it is seen on any ground.
template<class Draw>
void drawTwice(QPainter& painter, double width, const Draw& draw)
{
    painter.setPen(QPen(kDark, width + 2.0));
    draw();
    painter.setPen(QPen(kLight, width));
    draw();
}

QSizeF plateSize(QPainter& painter, const QRectF& area, const QString& text)
{
    const QRectF wide(0.0, 0.0, std::max(80.0, area.width() - 40.0), area.height());
    const QRectF bounds = painter.boundingRect(wide, Qt::AlignCenter | Qt::TextWordWrap, text);
    return {bounds.width() + 22.0, bounds.height() + 12.0};
}

/// Text on a dark rounded plate.
void drawPlate(QPainter& painter, const QRectF& plate, const QString& text)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 22, 26, 190));
    painter.drawRoundedRect(plate, 7.0, 7.0);
    painter.setPen(kLight);
    painter.drawText(plate, Qt::AlignCenter | Qt::TextWordWrap, text);
}

/// Around `center`, kept inside `area`.
void drawPlate(QPainter& painter, const QRectF& area, const QPointF& center, const QString& text)
{
    QRectF plate(QPointF(), plateSize(painter, area, text));
    plate.moveCenter(center);
    plate.moveLeft(std::clamp(plate.left(), area.left() + 4.0,
                              std::max(area.left() + 4.0, area.right() - plate.width() - 4.0)));
    drawPlate(painter, plate, text);
}

} // namespace

ViewportOverlay::ViewportOverlay(QWidget* parent) : QWidget(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
}

void ViewportOverlay::setPicture(const ToolPicture& picture)
{
    m_picture = picture;
    if (m_symbolOf != picture.symbol) {
        m_symbolOf = picture.symbol;
        m_symbol =
            m_symbolOf ? toolSymbol(*m_symbolOf, kSymbolSize - 6, devicePixelRatioF()) : QPixmap();
    }
    update();
}

void ViewportOverlay::setText(const OverlayText& text)
{
    if (m_text != text) {
        m_text = text;
        update();
    }
}

void ViewportOverlay::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintPlaces(painter);
    paintAreas(painter);
    paintSymbol(painter);
    paintLabel(painter);
    paintTexts(painter);
}

void ViewportOverlay::setPlaces(const std::vector<PlaceLabel>& places)
{
    if (m_places != places) {
        m_places = places;
        update();
    }
}

void ViewportOverlay::paintPlaces(QPainter& painter) const
{
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.9);
    painter.setFont(small);
    std::vector<const PlaceLabel*> named;
    std::vector<LabelWish> wishes;
    for (const PlaceLabel& place : m_places) {
        const double radius = place.isSelected ? 5.5 : 4.0;
        painter.setPen(QPen(place.isSelected ? kLight : kDark, place.isSelected ? 2.0 : 1.0));
        painter.setBrush(place.color);
        painter.drawEllipse(place.at, radius, radius);
        if (!place.text.isEmpty()) {
            named.push_back(&place);
            wishes.push_back({place.at, plateSize(painter, rect(), place.text), place.isSelected});
        }
    }
    const std::vector<std::optional<QRectF>> plates = layOutLabels(wishes, rect());
    for (std::size_t i = 0; i < named.size(); ++i) {
        if (plates[i]) {
            drawPlate(painter, *plates[i], named[i]->text);
        }
    }
    painter.setFont(font());
}

void ViewportOverlay::paintAreas(QPainter& painter) const
{
    painter.setBrush(Qt::NoBrush);
    for (const QPolygonF& outline : m_picture.outlines) {
        drawTwice(painter, 1.5, [&] { painter.drawPolyline(outline); });
    }
    if (m_picture.arrow) {
        painter.setPen(QPen(kLight, 1.5, Qt::DashLine));
        painter.drawLine(*m_picture.arrow);
    }
    if (m_picture.circle) {
        const double radius = m_picture.circle->radius;
        drawTwice(painter, 1.0,
                  [&] { painter.drawEllipse(m_picture.circle->center, radius, radius); });
    }
    if (m_picture.crosshair) {
        const QPointF at = *m_picture.crosshair;
        drawTwice(painter, 1.0, [&] {
            painter.drawLine(at - QPointF(kCrosshair, 0.0), at + QPointF(kCrosshair, 0.0));
            painter.drawLine(at - QPointF(0.0, kCrosshair), at + QPointF(0.0, kCrosshair));
        });
    }
    if (m_picture.rectangle) {
        painter.setBrush(QColor(255, 255, 255, 28));
        drawTwice(painter, 1.0, [&] {
            painter.drawRect(*m_picture.rectangle);
            painter.setBrush(Qt::NoBrush);
        });
    }
    if (m_picture.target) {
        const QPointF at = *m_picture.target;
        drawTwice(painter, 1.5, [&] {
            painter.drawEllipse(at, kTarget, kTarget);
            painter.drawEllipse(at, 1.5, 1.5);
        });
    }
    if (m_picture.gradient) {
        const QLineF line = *m_picture.gradient;
        drawTwice(painter, 2.0, [&] { painter.drawLine(line); });
        painter.setPen(QPen(kDark, 1.0));
        painter.setBrush(kLight);
        painter.drawEllipse(line.p1(), 4.0, 4.0);
        painter.setBrush(kAccent);
        painter.drawEllipse(line.p2(), 5.0, 5.0);
        painter.setBrush(Qt::NoBrush);
    }
}

void ViewportOverlay::paintSymbol(QPainter& painter) const
{
    if (!m_picture.symbol || m_symbol.isNull()) {
        return;
    }
    // Below right of the cursor, on the other side where the picture ends.
    QPointF corner = m_picture.symbolAt + QPointF(kSymbolGap, kSymbolGap);
    if (corner.x() + kSymbolSize > width()) {
        corner.setX(m_picture.symbolAt.x() - kSymbolGap - kSymbolSize);
    }
    if (corner.y() + kSymbolSize > height()) {
        corner.setY(m_picture.symbolAt.y() - kSymbolGap - kSymbolSize);
    }
    const QRectF plate(corner, QSizeF(kSymbolSize, kSymbolSize));
    painter.setPen(QPen(kDark, 1.0));
    painter.setBrush(QColor(250, 250, 250, 225));
    painter.drawRoundedRect(plate, 5.0, 5.0);
    painter.drawPixmap(plate.topLeft() + QPointF(3.0, 3.0), m_symbol);
}

void ViewportOverlay::paintLabel(QPainter& painter) const
{
    if (m_picture.label.isEmpty()) {
        return;
    }
    // Clear of the brush's outline; below it where there is no room above.
    QFont small = painter.font();
    small.setPointSizeF(small.pointSizeF() * 0.92);
    painter.setFont(small);
    const double away = (m_picture.circle ? m_picture.circle->radius : 6.0) + 20.0;
    const QPointF above = m_picture.symbolAt - QPointF(0.0, away);
    const QPointF below = m_picture.symbolAt + QPointF(0.0, away + kSymbolSize);
    drawPlate(painter, rect(), above.y() < 20.0 ? below : above, m_picture.label);
    painter.setFont(font());
}

void ViewportOverlay::paintTexts(QPainter& painter) const
{
    const QRectF area = rect();
    if (!m_text.help.isEmpty()) {
        QFont large = font();
        large.setPointSizeF(large.pointSizeF() * 1.2);
        painter.setFont(large);
        drawPlate(painter, area, area.center(), m_text.help);
        painter.setFont(font());
    }
    if (!m_text.mode.isEmpty()) {
        drawPlate(painter, area, {area.center().x(), 26.0}, m_text.mode);
    }
}

} // namespace crowd::widgets
