// SPDX-License-Identifier: MIT
#include "widgets/timeline/TimelinePicture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QtGui/QPainter>

namespace crowd::widgets {

using model::Mark;

namespace {

constexpr int kTextGap = 4; ///< logical pixels, as all below
constexpr int kLeastTitle = 16;
constexpr int kFiring = 2;
constexpr double kGoldenAngle = 137.508; ///< degrees: hues that follow each other differ most
constexpr QRgb kNow = 0xFFE04F4F;
constexpr QRgb kRange = 0xFF8B6BD1;
constexpr const char* kRules = QT_TRANSLATE_NOOP("Timeline", "Rules");
constexpr const char* kStripHint =
    QT_TRANSLATE_NOOP("Timeline", "Select characters: when which rules fired for them");
constexpr const char* kHint = QT_TRANSLATE_NOOP(
    "Timeline", "Double click in a lane: what is to happen then. Or record: cues that are pressed, "
                "states that are recalled and events that are painted while it plays come here.");

class Picture
{
public:
    Picture(QPainter& painter, const TimelineShown& shown) : m_painter(painter), m_shown(shown) {}
    void draw() const;

private:
    static constexpr int kNames = TimelineLayout::kNames;
    static constexpr int kRuler = TimelineLayout::kRuler;

    [[nodiscard]] int x(double seconds) const
    {
        const double at = std::clamp(m_shown.scale.x(seconds), -1e6, 1e6);
        return kNames + static_cast<int>(std::lround(at));
    }
    [[nodiscard]] const TimelineLayout& layout() const { return m_shown.layout; }
    [[nodiscard]] int width() const { return layout().size.width(); }
    [[nodiscard]] QColor color(QPalette::ColorRole role) const
    {
        return m_shown.palette.color(role);
    }
    void drawLane(int top, int height, QPalette::ColorRole role, const QString& name) const;
    void drawLanes() const;
    void drawRuler() const;
    void drawRange() const;
    void drawMarks() const;
    void drawMark(const Mark& mark, int room) const;
    void drawLength(const Mark& mark, const QPoint& at) const;
    void drawStrip() const;
    void drawNow() const;
    void drawHint() const;

    QPainter& m_painter;
    const TimelineShown& m_shown;
};

void Picture::draw() const
{
    m_painter.setRenderHint(QPainter::Antialiasing);
    m_painter.fillRect(QRect(QPoint(), layout().size), color(QPalette::Window));
    drawLanes();
    m_painter.save();
    m_painter.setClipRect(kNames, 0, width() - kNames, layout().size.height());
    drawRuler();
    drawRange();
    drawStrip();
    drawMarks();
    drawNow();
    m_painter.restore();
    drawHint();
}

void Picture::drawLane(int top, int height, QPalette::ColorRole role, const QString& name) const
{
    m_painter.fillRect(QRect(kNames, top, width() - kNames, height), color(role));
    m_painter.setPen(color(QPalette::WindowText));
    m_painter.drawText(QRect(6, top, kNames - 10, height), Qt::AlignVCenter | Qt::AlignLeft, name);
}

void Picture::drawLanes() const
{
    for (std::size_t i = 0; i < kTimelineLanes.size(); ++i) {
        drawLane(layout().topOf(i), layout().laneHeight(),
                 i % 2 == 0 ? QPalette::Base : QPalette::AlternateBase,
                 TimelineText::tr(kTimelineLanes[i].name));
    }
    drawLane(layout().stripTop(), TimelineLayout::kStrip, QPalette::Base, TimelineText::tr(kRules));
    const int from = std::max(kNames, x(m_shown.playedFrom));
    const int to = x(m_shown.playedTo);
    QColor tint = color(QPalette::Highlight);
    tint.setAlphaF(0.14F);
    if (to > from) {
        m_painter.fillRect(QRect(from, 0, to - from, layout().bottom()), tint);
    }
}

void Picture::drawRuler() const
{
    const double line = m_shown.scale.lineSeconds();
    const double last = m_shown.scale.seconds(width() - kNames);
    QColor faint = color(QPalette::WindowText);
    faint.setAlphaF(0.18F);
    for (double at = std::floor(m_shown.scale.first() / line) * line; at <= last; at += line) {
        m_painter.setPen(faint);
        m_painter.drawLine(x(at), 4, x(at), layout().bottom());
        m_painter.setPen(color(QPalette::WindowText));
        m_painter.drawText(QRect(x(at) + kTextGap, 0, 90, kRuler), Qt::AlignVCenter | Qt::AlignLeft,
                           m_shown.scale.text(at));
    }
}

/// A band at the foot of the ruler with a handle at each end; what is not played is dimmed.
void Picture::drawRange() const
{
    if (!m_shown.range.isSet()) {
        return;
    }
    const int from = x(m_shown.range.begin);
    const int to = x(m_shown.range.end);
    QColor dim = color(QPalette::Window);
    dim.setAlphaF(0.55F);
    const int height = layout().bottom() - kRuler;
    m_painter.fillRect(QRect(kNames, kRuler, std::max(0, from - kNames), height), dim);
    m_painter.fillRect(QRect(to, kRuler, std::max(0, width() - to), height), dim);
    const QColor range(kRange);
    m_painter.fillRect(QRect(from, kRuler - 5, to - from, 5), range);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(range);
    const int top = kRuler - 14;
    m_painter.drawPolygon(
        QPolygon({QPoint(from, top), QPoint(from + 8, kRuler), QPoint(from, kRuler)}));
    m_painter.drawPolygon(QPolygon({QPoint(to, top), QPoint(to, kRuler), QPoint(to - 8, kRuler)}));
    m_painter.setPen(QPen(range, 1.0));
    m_painter.drawLine(from, kRuler, from, layout().bottom());
    m_painter.drawLine(to, kRuler, to, layout().bottom());
}

void Picture::drawMarks() const
{
    std::array<int, kTimelineLanes.size()> next; // where the one after it in its lane is
    next.fill(width());
    for (auto mark = m_shown.ordered.rbegin(); mark != m_shown.ordered.rend(); ++mark) {
        const int at = x(m_shown.secondsOf(*mark));
        int& end = next[laneOf(mark->kind)];
        if (at <= width() + kMarkHalf &&
            at + m_shown.scale.pixels(mark->length()) >= kNames - 200) {
            drawMark(*mark, end - at);
        }
        end = at - kMarkHalf;
    }
}

/// How long it goes on.
void Picture::drawLength(const Mark& mark, const QPoint& at) const
{
    const double pixels = m_shown.scale.pixels(mark.length());
    if (pixels > 1.0) {
        QColor bar(kTimelineLanes[laneOf(mark.kind)].color);
        bar.setAlphaF(0.22F);
        const double height = layout().laneHeight() - 6; // as high as the name that stands in it
        m_painter.fillRect(QRectF(at.x(), at.y() - 0.5 * height, std::min(pixels, 1e5), height),
                           bar);
    }
}

void Picture::drawMark(const Mark& mark, int room) const
{
    const std::size_t lane = laneOf(mark.kind);
    const QPoint at(x(m_shown.secondsOf(mark)), layout().topOf(lane) + layout().laneHeight() / 2);
    drawLength(mark, at);
    const bool isChosen = m_shown.chosen.contains(mark.id);
    const bool isFlawed = m_shown.flawed.contains(mark.id);
    m_painter.setPen(
        QPen(color(isChosen ? QPalette::Highlight : QPalette::WindowText), isChosen ? 2.5 : 1.0));
    m_painter.setBrush(isFlawed ? QColor(kNow) : QColor(kTimelineLanes[lane].color));
    const int half = isChosen ? kMarkHalf + 1 : kMarkHalf;
    m_painter.drawPolygon(QPolygon({at + QPoint(0, -half), at + QPoint(half, 0),
                                    at + QPoint(0, half), at + QPoint(-half, 0)}));
    const int text = room - kMarkHalf - 2 * kTextGap;
    if (text < kLeastTitle) {
        return;
    }
    const QString title =
        (isFlawed ? QStringLiteral("⚠ ") : QString()) + markTitle(m_shown.scene, mark);
    m_painter.setPen(color(QPalette::Text));
    m_painter.drawText(QRect(at.x() + kMarkHalf + kTextGap, at.y() - TimelineLayout::kLane / 2,
                             text, TimelineLayout::kLane),
                       Qt::AlignVCenter | Qt::AlignLeft,
                       m_painter.fontMetrics().elidedText(title, Qt::ElideRight, text));
}

/// A tick for each firing, in a colour of its rule.
void Picture::drawStrip() const
{
    const QRect strip(kNames, layout().stripTop(), width() - kNames, TimelineLayout::kStrip);
    if (!m_shown.isAnybodySelected) {
        m_painter.setPen(m_shown.palette.color(QPalette::Disabled, QPalette::Text));
        m_painter.drawText(strip.adjusted(kTextGap * 2, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft,
                           TimelineText::tr(kStripHint));
        return;
    }
    int lastX = -1;
    model::RuleId lastRule = 0;
    const double first = m_shown.scale.seconds(-1.0);
    const double last = m_shown.scale.seconds(strip.width() + 1.0);
    auto each = std::ranges::lower_bound(m_shown.fired, first, {}, &behavior::RuleFired::seconds);
    for (; each != m_shown.fired.end() && each->seconds <= last; ++each) {
        const int at = x(each->seconds);
        if (at == lastX && each->rule == lastRule) {
            continue;
        }
        lastX = at;
        lastRule = each->rule;
        m_painter.fillRect(QRect(at, strip.top() + 3, kFiring, strip.height() - 6),
                           colorOfRule(each->rule));
    }
}

void Picture::drawNow() const
{
    const int now = x(m_shown.now);
    m_painter.setPen(QPen(QColor(kNow), 2.0));
    m_painter.drawLine(now, kRuler / 2, now, layout().bottom());
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(QColor(kNow));
    m_painter.drawPolygon(QPolygon(
        {QPoint(now - kMarkHalf, 2), QPoint(now + kMarkHalf, 2), QPoint(now, kRuler / 2)}));
}

void Picture::drawHint() const
{
    if (!m_shown.ordered.empty()) {
        return;
    }
    m_painter.setPen(m_shown.palette.color(QPalette::Disabled, QPalette::Text));
    m_painter.drawText(
        QRect(kNames + 12, kRuler, width() - kNames - 24, layout().stripTop() - kRuler),
        Qt::AlignCenter | Qt::TextWordWrap, TimelineText::tr(kHint));
}

} // namespace

QColor colorOfRule(model::RuleId rule)
{
    const double hue = std::fmod(static_cast<double>(rule) * kGoldenAngle, 360.0);
    return QColor::fromHsv(static_cast<int>(hue), 170, 190);
}

void drawTimeline(QPainter& painter, const TimelineShown& shown)
{
    Picture(painter, shown).draw();
}

} // namespace crowd::widgets
