// SPDX-License-Identifier: MIT
#include "widgets/viewport/FrameClock.h"

#include <algorithm>

namespace crowd::widgets {

namespace {

constexpr double kBeatMs = 1000.0 / 60.0;
constexpr double kLeastPauseMs = 4.0; ///< for input, however slow the pictures are

} // namespace

FrameClock::FrameClock(QObject* parent) : QObject(parent)
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &FrameClock::fire);
}

void FrameClock::setRunning(bool isRunning)
{
    if (m_isRunning == isRunning) {
        return;
    }
    m_isRunning = isRunning;
    if (isRunning) {
        m_sinceBeat.start();
        schedule();
    } else {
        m_timer.stop();
    }
}

void FrameClock::fire()
{
    const double seconds = static_cast<double>(m_sinceBeat.nsecsElapsed()) * 1e-9;
    m_sinceBeat.start();
    Q_EMIT beat(seconds);
    if (m_isRunning) {
        schedule();
    }
}

void FrameClock::schedule()
{
    m_timer.start(static_cast<int>(std::max(kBeatMs, m_lastFrameMs + kLeastPauseMs)));
}

} // namespace crowd::widgets
