// SPDX-License-Identifier: MIT
#include "app/window/TimeSlider.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QSignalBlocker>
#include <QtGui/QMouseEvent>
#include <QtWidgets/QStyle>
#include <QtWidgets/QStyleOptionSlider>

#include "widgets/state/SessionControl.h"

namespace crowd::app {

namespace {

constexpr int kWidth = 150; ///< logical pixels
constexpr double kPerSecond = 1000.0;

int ticks(double seconds)
{
    return static_cast<int>(std::lround(std::min(seconds, 1e6) * kPerSecond));
}

} // namespace

TimeSlider::TimeSlider(widgets::EditorState& state, QWidget* parent)
    : QSlider(Qt::Horizontal, parent), m_state(state)
{
    setObjectName(QStringLiteral("timeSlider"));
    setFixedWidth(kWidth);
    setFocusPolicy(Qt::NoFocus);
    setToolTip(tr("The run so far: drag to see any moment of it again. What is done to people "
                  "then happens at its latest moment."));
    connect(&state.transport(), &widgets::Transport::timeChanged, this, &TimeSlider::refresh);
    connect(&state.session(), &widgets::SessionControl::stateChanged, this, &TimeSlider::refresh);
    refresh();
}

void TimeSlider::refresh()
{
    const widgets::SessionControl& session = m_state.session();
    const double now = m_state.transport().seconds();
    const double live = std::max(session.liveSeconds(), now);
    setEnabled(live > session.firstSeconds());
    const QSignalBlocker blocker(this);
    setRange(ticks(session.firstSeconds()), std::max(ticks(live), 1));
    setValue(ticks(now));
}

void TimeSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    m_isHeld = true;
    m_playedBefore = m_state.transport().isPlaying();
    m_state.transport().setPlaying(false);
    seek(event->position().toPoint().x());
}

void TimeSlider::mouseMoveEvent(QMouseEvent* event)
{
    if (m_isHeld) {
        seek(event->position().toPoint().x());
    }
}

void TimeSlider::mouseReleaseEvent(QMouseEvent* event)
{
    if (m_isHeld && event->button() == Qt::LeftButton) {
        m_isHeld = false;
        m_state.transport().setPlaying(m_playedBefore);
    }
}

void TimeSlider::seek(int x)
{
    const widgets::SessionControl& session = m_state.session();
    QStyleOptionSlider option;
    initStyleOption(&option);
    const QRect groove =
        style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderGroove, this);
    const int handle =
        style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this).width();
    const int way = std::max(1, groove.width() - handle);
    const int at = x - groove.x() - handle / 2;
    const double share = std::clamp(static_cast<double>(at) / way, 0.0, 1.0);
    const double first = session.firstSeconds();
    m_state.transport().setSeconds(first + share * (session.liveSeconds() - first));
}

} // namespace crowd::app
