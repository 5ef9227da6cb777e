// SPDX-License-Identifier: MIT
#include "widgets/timeline/TimelineView.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <QtGui/QContextMenuEvent>
#include <QtGui/QKeyEvent>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>
#include <QtGui/QWheelEvent>
#include <QtWidgets/QApplication>
#include <QtWidgets/QMenu>

#include "model/rules/MarkFlaws.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/timeline/TimelinePicture.h"

namespace crowd::widgets {

using model::Mark;

namespace {

constexpr double kZoomStep = 1.15;
constexpr double kWheelNotch = 120.0;
constexpr double kPan = 60.0;        ///< pixels a notch
constexpr int kNear = 2;             ///< pixels beside a mark or a tick that still mean it
constexpr int kHandle = 9;           ///< pixels: width of a handle of the play range
constexpr int kHandleTop = 8;        ///< from the top of the ruler
constexpr int kStill = 3;            ///< pixels that a click may move
constexpr double kRoomToPlay = 1.25; ///< share of all there is that is seen while it plays
constexpr int kAimMs = 1500;         ///< from a movement of the mouse to a click
constexpr int kNames = TimelineLayout::kNames;
constexpr int kRuler = TimelineLayout::kRuler;

} // namespace

TimelineView::TimelineView(EditorState& state, QWidget* parent)
    : QWidget(parent), m_state(state), m_scrub(state), m_fired(state)
{
    setObjectName(QStringLiteral("timelineView"));
    setFocusPolicy(Qt::ClickFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (isOneOf<model::TimelineChanged, model::RulesChanged, model::StatesChanged,
                            model::CamerasChanged, model::PathsChanged, model::IndividualsAdded,
                            model::IndividualsRemoved, model::SceneReplaced>(change)) {
                    if (isOneOf<model::SceneReplaced>(change)) {
                        m_ordered = model::inOrder(m_state.scene().timeline);
                    }
                    followScene();
                }
            });
    connect(&state.transport(), &Transport::timeChanged, this, &TimelineView::followTime);
    connect(&state.session(), &SessionControl::stateChanged, this, [this] { update(); });
    connect(&state.session(), &SessionControl::takenFrom, this, [this] { update(); });
    connect(&m_fired, &SelectedFirings::changed, this, [this] { update(); });
    followScene();
}

QSize TimelineView::minimumSizeHint() const
{
    return {TimelineLayout::kLeastWidth, TimelineLayout::kLeastHeight};
}

void TimelineView::followScene()
{
    MarkIds known;
    for (const Mark& mark : m_ordered) {
        known.insert(mark.id);
    }
    m_ordered = model::inOrder(m_state.scene().timeline);
    m_flawed.clear();
    for (const auto& [id, flaw] : model::flawsOfMarks(m_state.scene())) {
        m_flawed.insert(id);
    }
    const auto before = m_chosen.size();
    std::erase_if(m_chosen, [this](model::MarkId id) {
        return model::findMark(m_state.scene().timeline, id) == nullptr;
    });
    if (m_chosen.size() != before) {
        m_drag.reset(); // undone under the hand
        Q_EMIT chosenChanged();
    }
    chooseNew(known);
    update();
}

/// One that has come by itself, or back by undo, is what is to be worked on; what is recorded is
/// not, and of another scene all are new.
void TimelineView::chooseNew(const MarkIds& known)
{
    const bool isOne = m_ordered.size() == known.size() + 1;
    const auto fresh = std::ranges::find_if(
        m_ordered, [&known](const Mark& mark) { return !known.contains(mark.id); });
    if (isOne && fresh != m_ordered.end() && !m_drag && !m_state.session().recorder().isOn()) {
        choose({fresh->id});
    }
}

void TimelineView::followTime(double seconds)
{
    if (!isVisible()) {
        return;
    }
    // Also where it jumps: to the beginning, to a marker.
    const bool isJump = !m_state.transport().isPlaying() && !m_scrub.isHeld();
    if ((m_state.transport().isPlaying() && !isAimedAt()) || isJump) {
        m_scale.reveal(seconds, width() - kNames);
    }
    update();
}

bool TimelineView::isAimedAt() const
{
    const bool isHeld = m_drag || m_rangeDrag || m_scrub.isHeld();
    return isHeld || (m_sinceAimed.isValid() && !m_sinceAimed.hasExpired(kAimMs));
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
        last = std::max(last, mark.seconds + mark.length());
    }
    last = std::max(last, m_state.scene().playRange.end);
    if (m_state.transport().isPlaying()) {
        last *= kRoomToPlay; // else the next moment would scroll it away
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
    const TimelineLayout layout = this->layout();
    return {placeOf(shownSeconds(mark)).x(),
            layout.topOf(laneOf(mark.kind)) + layout.laneHeight() / 2};
}

double TimelineView::shownSeconds(const Mark& mark) const
{
    const bool isMoved = m_drag && m_drag->isMoving && m_chosen.contains(mark.id);
    return isMoved ? std::max(0.0, mark.seconds + m_drag->seconds) : mark.seconds;
}

const Mark* TimelineView::markAt(const QPoint& at) const
{
    const Mark* diamond = diamondAt(at);
    return diamond != nullptr ? diamond : markThrough(at);
}

const Mark* TimelineView::diamondAt(const QPoint& at) const
{
    const Mark* nearest = nullptr;
    int least = kMarkHalf + kNear;
    const int reach = layout().laneHeight() / 2;
    for (const Mark& mark : m_ordered) {
        const QPoint away = placeOf(mark) - at;
        if (std::abs(away.y()) <= reach && std::abs(away.x()) <= least) {
            least = std::abs(away.x());
            nearest = &mark;
        }
    }
    return nearest;
}

/// Of which the bar or the name is there: of several the one that begins last.
const Mark* TimelineView::markThrough(const QPoint& at) const
{
    const auto kind = layout().laneAt(at.y());
    const Mark* through = nullptr;
    for (const Mark& mark : m_ordered) {
        const int from = placeOf(mark).x();
        if (!kind || mark.kind != *kind || from > at.x()) {
            continue;
        }
        const int name =
            kMarkHalf + kNear + fontMetrics().horizontalAdvance(markTitle(m_state.scene(), mark));
        const double reach = std::max<double>(name, m_scale.pixels(mark.length()));
        if (at.x() - from <= reach) {
            through = &mark;
        }
    }
    return at.x() >= kNames ? through : nullptr;
}

/// Keys that the window has actions for are the timeline's while marks are chosen.
bool TimelineView::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        if (takesKey(*static_cast<QKeyEvent*>(event))) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

bool TimelineView::takesKey(const QKeyEvent& event) const
{
    const int key = event.key();
    const bool isRemoval = key == Qt::Key_Delete || key == Qt::Key_Backspace;
    const bool isEnd = key == Qt::Key_Escape && (m_drag || m_rangeDrag);
    const bool isOfChosen = isRemoval || key == Qt::Key_Escape || event.matches(QKeySequence::Copy);
    return isEnd || (isOfChosen && !m_chosen.empty()) ||
           (event.matches(QKeySequence::Paste) && !m_copied.empty());
}

void TimelineView::copyChosen()
{
    m_copied = m_chosen;
    m_state.showStatus(tr("%n mark(s) copied: Ctrl+V puts them where the moment shown is", nullptr,
                          static_cast<int>(m_copied.size())));
}

/// The first of them at the moment that is shown.
void TimelineView::pasteCopied()
{
    MarkIds there;
    double first = std::numeric_limits<double>::max();
    for (const Mark& mark : m_state.scene().timeline) {
        if (m_copied.contains(mark.id)) {
            there.insert(mark.id);
            first = std::min(first, mark.seconds);
        }
    }
    if (there.empty()) {
        m_state.showStatus(tr("The marks that were copied are not there any more."));
        return;
    }
    choose(copyMarks(m_state, there, m_state.transport().seconds() - first));
}

void TimelineView::keyPressEvent(QKeyEvent* event)
{
    const bool isRemoval = event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace;
    if (isRemoval && !m_chosen.empty()) {
        removeChosen();
    } else if (event->matches(QKeySequence::Copy) && !m_chosen.empty()) {
        copyChosen();
    } else if (event->matches(QKeySequence::Paste) && !m_copied.empty()) {
        pasteCopied();
    } else if (event->key() == Qt::Key_Escape && giveUpDrags()) {
        event->accept();
    } else if (event->key() == Qt::Key_Escape && !m_chosen.empty()) {
        choose({});
    } else {
        QWidget::keyPressEvent(event);
    }
}

bool TimelineView::giveUpDrags()
{
    const bool wasDragging = m_drag || m_rangeDrag;
    m_drag.reset();
    m_rangeDrag.reset();
    update();
    return wasDragging;
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
    if (!beginRangeDrag(at, event->modifiers()) && at.x() >= kNames) {
        m_scrub.begin();
        showTimeAt(at.x());
    }
}

void TimelineView::showTimeAt(int x)
{
    m_scrub.show(m_scale.seconds(x - kNames));
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
    m_sinceAimed.start();
    const QPoint at = event->position().toPoint();
    if (m_rangeDrag) {
        const int way = std::abs(at.x() - m_rangeDrag->from.x());
        m_rangeDrag->isHeldStill = m_rangeDrag->isHeldStill && way <= kStill;
        m_rangeDrag->moving = m_scale.caught(m_scale.seconds(at.x() - kNames));
        update();
    } else if (m_scrub.isHeld()) {
        showTimeAt(at.x());
    } else if (m_drag && (event->buttons() & Qt::LeftButton) != 0) {
        // What is dragged stays in sight.
        const int way = std::clamp(at.x(), kNames, width() - kMarkHalf) - m_drag->from.x();
        m_drag->isMoving = m_drag->isMoving || std::abs(way) >= QApplication::startDragDistance();
        const Mark* first = model::findMark(m_state.scene().timeline, *m_chosen.begin());
        if (m_drag->isMoving && first != nullptr) {
            const double wanted = first->seconds + m_scale.seconds(way) - m_scale.first();
            m_drag->seconds = std::max(m_scale.caught(wanted) - first->seconds, -earliestChosen());
            m_state.showStatus(tr("%1 s").arg(first->seconds + m_drag->seconds, 0, 'f', 2));
        }
        update();
    } else {
        hover(at);
    }
}

void TimelineView::leaveEvent(QEvent* event)
{
    m_sinceAimed.invalidate();
    QWidget::leaveEvent(event);
}

void TimelineView::hover(const QPoint& at)
{
    const Mark* mark = markAt(at);
    QString tip;
    if (mark != nullptr) {
        tip =
            tr("%1, at %2 s").arg(markTitle(m_state.scene(), *mark)).arg(mark->seconds, 0, 'f', 2);
    } else if (layout().isStrip(at.y())) {
        tip = m_fired.text(m_scale.seconds(at.x() - kNames - kNear),
                           m_scale.seconds(at.x() - kNames + kNear));
    } else if (at.y() < kRuler) {
        tip = tr("Drag to see what has been played; with Shift held, what is to be played");
    }
    setToolTip(tip);
    const bool isMoved = mark != nullptr || handleAt(at).has_value();
    setCursor(isMoved ? Qt::SizeHorCursor : Qt::ArrowCursor);
}

/// The end of the range that stays where it is, if the other one is there.
std::optional<double> TimelineView::handleAt(const QPoint& at) const
{
    const model::PlayRange& range = m_state.scene().playRange;
    if (!range.isSet() || at.y() < kHandleTop || at.y() > kRuler) {
        return std::nullopt;
    }
    const int fromBegin = at.x() - placeOf(range.begin).x();
    const int fromEnd = placeOf(range.end).x() - at.x();
    if (fromEnd >= -kNear && fromEnd <= kHandle) {
        return range.begin;
    }
    return fromBegin >= -kNear && fromBegin <= kHandle ? std::optional(range.end) : std::nullopt;
}

/// At one of its ends, or anywhere on the ruler with Shift held.
bool TimelineView::beginRangeDrag(const QPoint& at, Qt::KeyboardModifiers modifiers)
{
    const double here = m_scale.caught(m_scale.seconds(at.x() - kNames));
    const auto handle = handleAt(at);
    const bool isNew = (modifiers & Qt::ShiftModifier) != 0 && at.y() < kRuler && at.x() >= kNames;
    if (handle) {
        m_rangeDrag = RangeDrag{*handle, here, at, true};
    } else if (isNew) {
        m_rangeDrag = RangeDrag{here, here, at, false};
    }
    return m_rangeDrag.has_value();
}

model::PlayRange TimelineView::shownRange() const
{
    model::PlayRange range = m_state.scene().playRange;
    if (m_rangeDrag && !m_rangeDrag->isHeldStill) {
        range.begin = std::min(m_rangeDrag->fixed, m_rangeDrag->moving);
        range.end = std::max(m_rangeDrag->fixed, m_rangeDrag->moving);
    }
    return range;
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
    endRangeDrag();
}

void TimelineView::endRangeDrag()
{
    const model::PlayRange range = shownRange();
    const auto drag = std::exchange(m_rangeDrag, std::nullopt);
    if (drag && drag->isHeldStill) {
        showTimeAt(drag->from.x());
    } else if (drag) {
        setPlayRange(m_state, range);
    }
    update();
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
    const auto kind = layout().laneAt(at.y());
    if (event->button() != Qt::LeftButton || !kind || at.x() < kNames) {
        return;
    }
    if (const Mark* mark = diamondAt(at)) { // within a bar something else can begin
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
        for (const TimelineLane& lane : kTimelineLanes) {
            menu.addAction(TimelineText::tr(lane.add), this, [this, kind = lane.kind, seconds] {
                if (const auto id = addMark(m_state, kind, seconds)) {
                    choose({id});
                }
            });
        }
        menu.addSeparator();
        addRangeActions(menu, seconds);
        menu.addSeparator();
        menu.addAction(tr("Show All"), this, &TimelineView::showAll);
    }
    menu.exec(event->globalPos());
}

void TimelineView::addRangeActions(QMenu& menu, double seconds)
{
    menu.addAction(tr("Play from Here On"), this,
                   [this, seconds] { beginPlayRange(m_state, seconds); });
    menu.addAction(tr("Play until Here"), this,
                   [this, seconds] { endPlayRange(m_state, seconds); });
    if (m_state.scene().playRange.isSet()) {
        menu.addAction(tr("Play All Time"), this, [this] { setPlayRange(m_state, {}); });
    }
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
    drawTimeline(painter, {.scene = m_state.scene(),
                           .scale = m_scale,
                           .ordered = m_ordered,
                           .chosen = m_chosen,
                           .flawed = m_flawed,
                           .secondsOf = [this](const Mark& mark) { return shownSeconds(mark); },
                           .range = shownRange(),
                           .playedFrom = m_scrub.first(),
                           .playedTo = m_scrub.last(),
                           .now = m_state.transport().seconds(),
                           .isAnybodySelected = !m_state.selection().isEmpty(),
                           .fired = m_fired.shown(),
                           .layout = layout(),
                           .palette = palette()});
}

} // namespace crowd::widgets
