// SPDX-License-Identifier: MIT
#include "widgets/docks/TimelineView.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QtGui/QContextMenuEvent>
#include <QtGui/QKeyEvent>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>
#include <QtGui/QWheelEvent>
#include <QtWidgets/QApplication>
#include <QtWidgets/QMenu>

#include "widgets/state/SceneChanges.h"

namespace crowd::widgets {

using model::Mark;
using model::MarkKind;

namespace {

constexpr int kRuler = 22; ///< logical pixels, as all below
constexpr int kLane = 24;  ///< at least
constexpr int kHighestLane = 44;
constexpr int kNames = 84; ///< of lanes
constexpr int kMark = 6;   ///< half of it
constexpr int kTextGap = 4;
constexpr int kLeastTitle = 16;
constexpr double kZoomStep = 1.15;
constexpr double kWheelNotch = 120.0;
constexpr double kPan = 60.0; ///< a notch

struct Lane
{
    MarkKind kind;
    const char* name;
    const char* add;
    QRgb color;
};

constexpr std::array kLanes{Lane{MarkKind::Marker, QT_TRANSLATE_NOOP("Timeline", "Markers"),
                                 QT_TRANSLATE_NOOP("Timeline", "Add a Marker Here"), 0xFFC9A227},
                            Lane{MarkKind::Cue, QT_TRANSLATE_NOOP("Timeline", "Cues"),
                                 QT_TRANSLATE_NOOP("Timeline", "Call a Cue Here"), 0xFFD9703B},
                            Lane{MarkKind::State, QT_TRANSLATE_NOOP("Timeline", "States"),
                                 QT_TRANSLATE_NOOP("Timeline", "Recall a State Here"), 0xFF4C86C6},
                            Lane{MarkKind::Event, QT_TRANSLATE_NOOP("Timeline", "Events"),
                                 QT_TRANSLATE_NOOP("Timeline", "Send an Event Here"), 0xFF5AA469}};

struct TimelineText
{
    static QString tr(const char* text) { return QCoreApplication::translate("Timeline", text); }
};

std::size_t laneOf(MarkKind kind)
{
    return static_cast<std::size_t>(std::ranges::find(kLanes, kind, &Lane::kind) - kLanes.begin());
}

/// How long it goes on.
double lengthOf(const Mark& mark)
{
    return mark.kind == MarkKind::State ? static_cast<double>(mark.fade + mark.spread) : 0.0;
}

} // namespace

TimelineView::TimelineView(EditorState& state, QWidget* parent)
    : QWidget(parent), m_state(state), m_scrub(state)
{
    setObjectName(QStringLiteral("timelineView"));
    setFocusPolicy(Qt::ClickFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (isOneOf<model::TimelineChanged, model::RulesChanged, model::StatesChanged,
                            model::SceneReplaced>(change)) {
                    followScene();
                }
            });
    connect(&state.transport(), &Transport::timeChanged, this, &TimelineView::followTime);
    connect(&state.session(), &SessionControl::stateChanged, this, [this] { update(); });
    followScene();
}

QSize TimelineView::minimumSizeHint() const
{
    return {kNames + 160, kRuler + static_cast<int>(kLanes.size()) * kLane + 2};
}

int TimelineView::laneHeight() const
{
    const auto lanes = static_cast<int>(kLanes.size());
    return std::clamp((height() - kRuler - 2) / lanes, kLane, kHighestLane);
}

int TimelineView::topOf(std::size_t lane) const
{
    return kRuler + static_cast<int>(lane) * laneHeight();
}

void TimelineView::followScene()
{
    m_ordered = model::inOrder(m_state.scene().timeline);
    const auto before = m_chosen.size();
    std::erase_if(m_chosen, [this](model::MarkId id) {
        return model::findMark(m_state.scene().timeline, id) == nullptr;
    });
    if (m_chosen.size() != before) {
        m_drag.reset(); // undone under the hand
        Q_EMIT chosenChanged();
    }
    update();
}

void TimelineView::followTime(double seconds)
{
    if (!isVisible()) {
        return;
    }
    if (m_state.transport().isPlaying()) {
        m_scale.reveal(seconds, width() - kNames);
    }
    update();
}

void TimelineView::choose(MarkIds marks)
{
    if (marks != m_chosen) {
        m_chosen = std::move(marks);
        Q_EMIT chosenChanged();
        update();
    }
}

void TimelineView::setFrameRate(int perSecond)
{
    m_scale.setFrameRate(perSecond);
    update();
}

void TimelineView::showAll()
{
    double last = m_state.session().liveSeconds();
    for (const Mark& mark : m_ordered) {
        last = std::max(last, mark.seconds + lengthOf(mark));
    }
    m_isToFit = !isVisible() || width() < minimumSizeHint().width(); // not laid out yet
    m_scale.fit(last, width() - kNames);
    update();
}

void TimelineView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fitAtFirst();
}

void TimelineView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    fitAtFirst();
}

void TimelineView::fitAtFirst()
{
    if (m_isToFit && isVisible()) {
        showAll();
    }
}

QPoint TimelineView::placeOf(double seconds) const
{
    const double x = std::clamp(m_scale.x(seconds), -1e6, 1e6);
    return {kNames + static_cast<int>(std::lround(x)), kRuler / 2};
}

QPoint TimelineView::placeOf(const Mark& mark) const
{
    return {placeOf(shownSeconds(mark)).x(), topOf(laneOf(mark.kind)) + laneHeight() / 2};
}

double TimelineView::shownSeconds(const Mark& mark) const
{
    const bool isMoved = m_drag && m_drag->isMoving && m_chosen.contains(mark.id);
    return isMoved ? std::max(0.0, mark.seconds + m_drag->seconds) : mark.seconds;
}

const Mark* TimelineView::markAt(const QPoint& at) const
{
    const Mark* nearest = nullptr;
    int least = kMark + 2;
    for (const Mark& mark : m_ordered) {
        const QPoint away = placeOf(mark) - at;
        if (std::abs(away.y()) <= laneHeight() / 2 && std::abs(away.x()) <= least) {
            least = std::abs(away.x());
            nearest = &mark;
        }
    }
    return nearest;
}

std::optional<MarkKind> TimelineView::laneAt(int y) const
{
    const int lane = (y - kRuler) / laneHeight();
    if (y < kRuler || lane >= static_cast<int>(kLanes.size())) {
        return std::nullopt;
    }
    return kLanes[static_cast<std::size_t>(lane)].kind;
}

/// Keys that the window has actions for are the timeline's while marks are chosen.
bool TimelineView::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && !m_chosen.empty()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Delete || key->key() == Qt::Key_Backspace ||
            key->key() == Qt::Key_Escape) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void TimelineView::keyPressEvent(QKeyEvent* event)
{
    const bool isRemoval = event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace;
    if (isRemoval && !m_chosen.empty()) {
        removeChosen();
    } else if (event->key() == Qt::Key_Escape && !m_chosen.empty()) {
        m_drag.reset();
        choose({});
        update();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void TimelineView::removeChosen()
{
    removeMarks(m_state, MarkIds(m_chosen));
}

void TimelineView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    const QPoint at = event->position().toPoint();
    if (const Mark* mark = markAt(at)) {
        beginDrag(*mark, *event);
        return;
    }
    choose({});
    if (at.x() >= kNames) {
        m_scrub.begin();
        m_scrub.show(m_scale.seconds(at.x() - kNames));
    }
}

void TimelineView::beginDrag(const Mark& mark, const QMouseEvent& event)
{
    const bool isMore = (event.modifiers() & Qt::ShiftModifier) != 0;
    if (!m_chosen.contains(mark.id)) {
        MarkIds chosen = isMore ? m_chosen : MarkIds();
        chosen.insert(mark.id);
        choose(std::move(chosen));
    } else if (isMore) {
        MarkIds chosen = m_chosen;
        chosen.erase(mark.id);
        choose(std::move(chosen));
        return;
    }
    m_drag = Drag{event.position().toPoint(), 0.0, false,
                  (event.modifiers() & Qt::ControlModifier) != 0};
}

void TimelineView::mouseMoveEvent(QMouseEvent* event)
{
    const QPoint at = event->position().toPoint();
    if (m_scrub.isHeld()) {
        m_scrub.show(m_scale.seconds(at.x() - kNames));
    } else if (m_drag && (event->buttons() & Qt::LeftButton) != 0) {
        const int way = at.x() - m_drag->from.x();
        m_drag->isMoving = m_drag->isMoving || std::abs(way) >= QApplication::startDragDistance();
        const Mark* first = model::findMark(m_state.scene().timeline, *m_chosen.begin());
        if (m_drag->isMoving && first != nullptr) {
            const double wanted = first->seconds + m_scale.seconds(way) - m_scale.first();
            m_drag->seconds = std::max(m_scale.caught(wanted) - first->seconds, -earliestChosen());
            m_state.showStatus(tr("%1 s").arg(first->seconds + m_drag->seconds, 0, 'f', 2));
        }
        update();
    } else {
        const Mark* mark = markAt(at);
        setToolTip(mark == nullptr ? QString()
                                   : tr("%1, at %2 s")
                                         .arg(markTitle(m_state.scene(), *mark))
                                         .arg(mark->seconds, 0, 'f', 2));
        setCursor(mark != nullptr ? Qt::SizeHorCursor : Qt::ArrowCursor);
    }
}

/// Seconds; dragged, they stay as far from each other as they are.
double TimelineView::earliestChosen() const
{
    const auto earliest = std::ranges::find_if(
        m_ordered, [this](const Mark& mark) { return m_chosen.contains(mark.id); });
    return earliest != m_ordered.end() ? earliest->seconds : 0.0;
}

void TimelineView::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    m_scrub.end();
    endDrag();
}

void TimelineView::endDrag()
{
    const auto drag = std::exchange(m_drag, std::nullopt);
    if (drag && drag->isMoving && drag->seconds != 0.0) {
        if (drag->isCopy) {
            choose(copyMarks(m_state, m_chosen, drag->seconds));
        } else {
            shiftMarks(m_state, m_chosen, drag->seconds);
        }
    }
    update();
}

void TimelineView::mouseDoubleClickEvent(QMouseEvent* event)
{
    const QPoint at = event->position().toPoint();
    const auto kind = laneAt(at.y());
    if (event->button() != Qt::LeftButton || !kind || at.x() < kNames) {
        return;
    }
    if (const Mark* mark = markAt(at)) {
        showMoment(m_state, mark->seconds);
    } else if (const auto id =
                   addMark(m_state, *kind, m_scale.caught(m_scale.seconds(at.x() - kNames)))) {
        choose({id});
    }
}

void TimelineView::contextMenuEvent(QContextMenuEvent* event)
{
    const Mark* mark = markAt(event->pos());
    QMenu menu(this);
    if (mark != nullptr) {
        if (!m_chosen.contains(mark->id)) {
            choose({mark->id});
        }
        menu.addAction(tr("Show This Moment"), this,
                       [this, seconds = mark->seconds] { showMoment(m_state, seconds); });
        menu.addAction(tr("Duplicate"), this,
                       [this] { choose(copyMarks(m_state, m_chosen, 1.0)); });
        menu.addSeparator();
        menu.addAction(tr("Remove"), this, &TimelineView::removeChosen);
    } else {
        const double seconds = m_scale.caught(m_scale.seconds(event->pos().x() - kNames));
        for (const Lane& lane : kLanes) {
            menu.addAction(TimelineText::tr(lane.add), this, [this, kind = lane.kind, seconds] {
                if (const auto id = addMark(m_state, kind, seconds)) {
                    choose({id});
                }
            });
        }
        menu.addSeparator();
        menu.addAction(tr("Show All"), this, &TimelineView::showAll);
    }
    menu.exec(event->globalPos());
}

void TimelineView::wheelEvent(QWheelEvent* event)
{
    const QPoint turned = event->angleDelta();
    const bool isPan = (event->modifiers() & Qt::ShiftModifier) != 0 || turned.x() != 0;
    if (isPan) {
        const int notches = turned.x() != 0 ? turned.x() : turned.y();
        m_scale.move(-notches / kWheelNotch * kPan);
    } else {
        m_scale.zoom(std::pow(kZoomStep, turned.y() / kWheelNotch),
                     std::max(0.0, event->position().x() - kNames));
    }
    event->accept();
    update();
}

void TimelineView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintLanes(painter);
    painter.save();
    painter.setClipRect(kNames, 0, width() - kNames, height());
    paintRuler(painter);
    paintMarks(painter);
    paintNow(painter);
    painter.restore();
    paintHint(painter);
}

void TimelineView::paintLanes(QPainter& painter) const
{
    const QPalette& colors = palette();
    painter.fillRect(rect(), colors.color(QPalette::Window));
    for (std::size_t i = 0; i < kLanes.size(); ++i) {
        const QRect lane(0, topOf(i), width(), laneHeight());
        const auto role = i % 2 == 0 ? QPalette::Base : QPalette::AlternateBase;
        painter.fillRect(lane.adjusted(kNames, 0, 0, 0), colors.color(role));
        painter.setPen(colors.color(QPalette::WindowText));
        painter.drawText(lane.adjusted(6, 0, 0, 0).intersected(QRect(0, 0, kNames - 4, height())),
                         Qt::AlignVCenter | Qt::AlignLeft, TimelineText::tr(kLanes[i].name));
    }
    const int from = std::max(kNames, placeOf(m_scrub.first()).x());
    const int to = placeOf(m_scrub.last()).x();
    QColor tint = colors.color(QPalette::Highlight);
    tint.setAlphaF(0.14F);
    if (to > from) {
        painter.fillRect(QRect(from, 0, to - from, topOf(kLanes.size())), tint);
    }
}

void TimelineView::paintRuler(QPainter& painter) const
{
    const double line = m_scale.lineSeconds();
    const double last = m_scale.seconds(width() - kNames);
    QColor faint = palette().color(QPalette::WindowText);
    faint.setAlphaF(0.18F);
    for (double at = std::floor(m_scale.first() / line) * line; at <= last; at += line) {
        const int x = placeOf(at).x();
        painter.setPen(faint);
        painter.drawLine(x, 4, x, topOf(kLanes.size()));
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(QRect(x + kTextGap, 0, 90, kRuler), Qt::AlignVCenter | Qt::AlignLeft,
                         m_scale.text(at));
    }
}

void TimelineView::paintMarks(QPainter& painter) const
{
    std::array<int, kLanes.size()> next; // where the one after it in its lane is
    next.fill(width());
    for (auto mark = m_ordered.rbegin(); mark != m_ordered.rend(); ++mark) {
        const int x = placeOf(*mark).x();
        int& end = next[laneOf(mark->kind)];
        if (x <= width() + kMark && x + m_scale.pixels(lengthOf(*mark)) >= kNames - 200) {
            paintMark(painter, *mark, end - x);
        }
        end = x - kMark;
    }
}

void TimelineView::paintMark(QPainter& painter, const Mark& mark, int room) const
{
    const QPoint at = placeOf(mark);
    const QColor color(kLanes[laneOf(mark.kind)].color);
    const bool isChosen = m_chosen.contains(mark.id);
    if (const double pixels = m_scale.pixels(lengthOf(mark)); pixels > 1.0) {
        QColor bar = color;
        bar.setAlphaF(0.35F);
        painter.fillRect(QRectF(at.x(), at.y() - kMark + 2, std::min(pixels, 1e5), 2 * kMark - 4),
                         bar);
    }
    painter.setPen(QPen(palette().color(isChosen ? QPalette::Highlight : QPalette::WindowText),
                        isChosen ? 2.5 : 1.0));
    painter.setBrush(color);
    const int half = isChosen ? kMark + 1 : kMark;
    painter.drawPolygon(QPolygon({at + QPoint(0, -half), at + QPoint(half, 0), at + QPoint(0, half),
                                  at + QPoint(-half, 0)}));
    const int text = room - kMark - 2 * kTextGap;
    if (text >= kLeastTitle) {
        painter.setPen(palette().color(QPalette::Text));
        const QString title = painter.fontMetrics().elidedText(markTitle(m_state.scene(), mark),
                                                               Qt::ElideRight, text);
        painter.drawText(QRect(at.x() + kMark + kTextGap, at.y() - kLane / 2, text, kLane),
                         Qt::AlignVCenter | Qt::AlignLeft, title);
    }
}

void TimelineView::paintNow(QPainter& painter) const
{
    const int x = placeOf(m_state.transport().seconds()).x();
    const QColor red(0xE0, 0x4F, 0x4F);
    painter.setPen(QPen(red, 2.0));
    painter.drawLine(x, kRuler / 2, x, topOf(kLanes.size()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(red);
    painter.drawPolygon(
        QPolygon({QPoint(x - kMark, 2), QPoint(x + kMark, 2), QPoint(x, kRuler / 2)}));
}

void TimelineView::paintHint(QPainter& painter) const
{
    if (!m_ordered.empty()) {
        return;
    }
    painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
    painter.drawText(
        QRect(kNames + 12, kRuler, width() - kNames - 24, topOf(kLanes.size()) - kRuler),
        Qt::AlignCenter | Qt::TextWordWrap,
        tr("Double click in a lane: what is to happen then. Or record: cues that are "
           "pressed, states that are recalled and events that are painted while it "
           "plays come here."));
}

} // namespace crowd::widgets
