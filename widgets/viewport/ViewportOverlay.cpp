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
constexpr double kLabelSize = 0.92; ///< of the window's font
constexpr double kLabelWidth = 320.0;

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

QFont resized(QFont font, double share)
{
    font.setPointSizeF(font.pointSizeF() * share);
    return font;
}

/// In several lines where `widest` is less than the text.
QSizeF plateSize(const QFont& font, double widest, const QString& text)
{
    const QRectF wide(0.0, 0.0, widest, 1000.0);
    const QRectF bounds =
        QFontMetricsF(font).boundingRect(wide, Qt::AlignCenter | Qt::TextWordWrap, text);
    return {bounds.width() + 22.0, bounds.height() + 12.0};
}

double widestIn(const QRectF& area)
{
    return std::max(80.0, area.width() - 40.0);
}

/// Around `center`, kept between the sides of `area`.
QRectF plateAround(const QRectF& area, const QPointF& center, const QSizeF& size)
{
    QRectF plate(QPointF(), size);
    plate.moveCenter(center);
    plate.moveLeft(std::clamp(plate.left(), area.left() + 4.0,
                              std::max(area.left() + 4.0, area.right() - plate.width() - 4.0)));
    return plate;
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

void drawPlate(QPainter& painter, const QRectF& area, const QPointF& center, const QString& text)
{
    const QSizeF size = plateSize(painter.font(), widestIn(area), text);
    drawPlate(painter, plateAround(area, center, size), text);
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
    const QFont small = resized(font(), 0.9);
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
            wishes.push_back(
                {place.at, plateSize(small, widestIn(rect()), place.text), place.isSelected});
        }
    }
    std::vector<QRectF> taken;
    if (!m_picture.label.isEmpty()) {
        taken.push_back(labelPlate());
    }
    const std::vector<std::optional<QRectF>> plates =
        layOutLabels(wishes, rect(), std::move(taken));
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

/// Clear of the brush's outline; below it where there is no room above. Long ones in several lines,
/// so that they stay at the cursor.
QRectF ViewportOverlay::labelPlate() const
{
    const double away = (m_picture.circle ? m_picture.circle->radius : 6.0) + 6.0;
    const double widest = std::min(kLabelWidth, widestIn(rect()));
    const QSizeF size = plateSize(resized(font(), kLabelSize), widest, m_picture.label);
    const QPointF shift(0.0, away + 0.5 * size.height());
    const QPointF above = m_picture.symbolAt - shift;
    const QPointF below = m_picture.symbolAt + shift + QPointF(0.0, kSymbolSize);
    return plateAround(rect(), above.y() < 0.5 * size.height() ? below : above, size);
}

void ViewportOverlay::paintLabel(QPainter& painter) const
{
    if (m_picture.label.isEmpty()) {
        return;
    }
    painter.setFont(resized(font(), kLabelSize));
    drawPlate(painter, labelPlate(), m_picture.label);
    painter.setFont(font());
}

void ViewportOverlay::paintTexts(QPainter& painter) const
{
    const QRectF area = rect();
    if (!m_text.help.isEmpty()) {
        painter.setFont(resized(font(), 1.2));
        drawPlate(painter, area, area.center(), m_text.help);
        painter.setFont(font());
    }
    if (!m_text.mode.isEmpty()) {
        drawPlate(painter, area, {area.center().x(), 26.0}, m_text.mode);
    }
}

} // namespace crowd::widgets
