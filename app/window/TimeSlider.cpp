// SPDX-License-Identifier: MIT
#include "app/window/TimeSlider.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QSignalBlocker>
#include <QtGui/QMouseEvent>
#include <QtWidgets/QStyle>
#include <QtWidgets/QStyleOptionSlider>

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
    : QSlider(Qt::Horizontal, parent), m_state(state), m_scrub(state)
{
    setObjectName(QStringLiteral("timeSlider"));
    setFixedWidth(kWidth);
    setFocusPolicy(Qt::NoFocus);
    setToolTip(tr("The run so far: drag to see any moment of it again. What is done to people "
                  "then happens there, and what came after is played anew."));
    connect(&state.transport(), &widgets::Transport::timeChanged, this, &TimeSlider::refresh);
    connect(&state.session(), &widgets::SessionControl::stateChanged, this, &TimeSlider::refresh);
    connect(&state.session(), &widgets::SessionControl::takenFrom, this, &TimeSlider::refresh);
    connect(&state.session(), &widgets::SessionControl::stepped, this, &TimeSlider::refresh);
    refresh();
}

void TimeSlider::refresh()
{
    setEnabled(m_scrub.last() > m_scrub.first());
    const QSignalBlocker blocker(this);
    setRange(ticks(m_scrub.first()), std::max(ticks(m_scrub.last()), 1));
    setValue(ticks(m_state.transport().seconds()));
}

void TimeSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    m_scrub.begin();
    seek(event->position().toPoint().x());
}

void TimeSlider::mouseMoveEvent(QMouseEvent* event)
{
    if (m_scrub.isHeld()) {
        seek(event->position().toPoint().x());
    }
}

void TimeSlider::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        m_scrub.end();
    }
}

void TimeSlider::seek(int x)
{
    QStyleOptionSlider option;
    initStyleOption(&option);
    const QRect groove =
        style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderGroove, this);
    const int handle =
        style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this).width();
    const int way = std::max(1, groove.width() - handle);
    const int at = x - groove.x() - handle / 2;
    const double share = std::clamp(static_cast<double>(at) / way, 0.0, 1.0);
    m_scrub.show(m_scrub.first() + share * (m_scrub.last() - m_scrub.first()));
}

} // namespace crowd::app
