// SPDX-License-Identifier: MIT
#include "widgets/viewport/ViewportOverlay.h"

#include <algorithm>

#include <QtGui/QPainter>
#include <QtGui/QPainterPath>

#include "widgets/viewport/BrushCursor.h"
#include "widgets/viewport/LabelLayout.h"
#include "widgets/viewport/PathLabels.h"

namespace crowd::widgets {

namespace {

constexpr double kSymbolSize = 26.0;
constexpr double kTarget = 8.0;

const QColor kDark = QColor::fromRgba(kOverlayDark);
const QColor kLight = QColor::fromRgba(kOverlayLight);
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
        m_symbol = m_symbolOf ? brushSymbol(*m_symbolOf, devicePixelRatioF()) : QPixmap();
    }
    update();
}

void ViewportOverlay::setBrushCarried(bool isCarried)
{
    if (m_isBrushCarried != isCarried) {
        m_isBrushCarried = isCarried;
        update();
    }
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
    paintLegend(painter);
    paintCandidates(painter);
    paintAreas(painter);
    if (!m_isBrushCarried) {
        paintBrushSymbol(painter, m_picture, m_symbol, rect());
    }
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

void ViewportOverlay::setLegend(const std::vector<TagLabel>& tags)
{
    if (m_legend != tags) {
        m_legend = tags;
        update();
    }
}

/// Top left, a line a tag; what does not fit is counted.
void ViewportOverlay::paintLegend(QPainter& painter) const
{
    if (m_legend.empty()) {
        return;
    }
    constexpr double kEdge = 8.0;
    constexpr double kDot = 9.0;
    const QFontMetricsF metrics(font());
    const double line = metrics.height() + 3.0;
    const auto fitting = static_cast<std::size_t>(std::max(1.0, (height() * 0.6) / line));
    const std::size_t shown = std::min(m_legend.size(), fitting);
    QStringList texts;
    double widest = 0.0;
    for (std::size_t i = 0; i < shown; ++i) {
        texts << metrics.elidedText(m_legend[i].name, Qt::ElideRight, width() * 0.3);
    }
    if (shown < m_legend.size()) {
        texts << tr("and %n more", nullptr, static_cast<int>(m_legend.size() - shown));
    }
    for (const QString& text : texts) {
        widest = std::max(widest, metrics.horizontalAdvance(text));
    }
    const QRectF plate(kEdge, kEdge, widest + kDot + 26.0,
                       line * static_cast<double>(texts.size()) + 10.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 22, 26, 190));
    painter.drawRoundedRect(plate, 7.0, 7.0);
    for (qsizetype i = 0; i < texts.size(); ++i) {
        const QRectF row(plate.left() + 9.0, plate.top() + 5.0 + line * static_cast<double>(i),
                         plate.width() - 14.0, line);
        if (static_cast<std::size_t>(i) < shown) {
            painter.setPen(QPen(m_legend[static_cast<std::size_t>(i)].color, 3.0));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(QPointF(row.left() + kDot / 2.0, row.center().y()), kDot / 2.0,
                                kDot / 2.0);
        }
        painter.setPen(kLight);
        painter.drawText(row.adjusted(kDot + 8.0, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter,
                         texts[i]);
    }
}

/// Whom the brush would reach.
void ViewportOverlay::paintCandidates(QPainter& painter) const
{
    constexpr double kRadius = 2.5;
    painter.setPen(QPen(kDark, 1.5));
    painter.setBrush(kLight);
    for (const QPointF& at : m_picture.candidates) {
        painter.drawEllipse(at, kRadius, kRadius);
    }
    painter.setBrush(Qt::NoBrush);
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
    if (!m_isBrushCarried) {
        paintBrushArea(painter, m_picture);
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
