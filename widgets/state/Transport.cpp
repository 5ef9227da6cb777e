// SPDX-License-Identifier: MIT
#include "widgets/state/Transport.h"

#include <algorithm>

namespace crowd::widgets {

namespace {

constexpr double kLongestPlayStep = 2.0;
constexpr double kPaceSeconds = 1.0; ///< real time over which the pace is a mean
constexpr double kSlowestPlay = 0.05;
constexpr double kFastestPlay = 8.0;

} // namespace

Transport::Transport(QObject* parent) : QObject(parent) {}

void Transport::setPlaying(bool isPlaying)
{
    if (m_state.isPlaying == isPlaying) {
        return;
    }
    m_state.isPlaying = isPlaying;
    m_pace = 1.0;
    Q_EMIT stateChanged(m_state);
}

void Transport::setSeconds(double seconds)
{
    const double bounded = std::max(seconds, 0.0);
    if (m_state.seconds == bounded) {
        return;
    }
    m_state.seconds = bounded;
    Q_EMIT stateChanged(m_state);
    Q_EMIT timeChanged(m_state.seconds);
}

void Transport::setSpeed(double speed)
{
    const double bounded = std::clamp(speed, kSlowestPlay, kFastestPlay);
    if (m_state.speed == bounded) {
        return;
    }
    m_state.speed = bounded;
    m_pace = 1.0;
    Q_EMIT stateChanged(m_state);
}

void Transport::advance(double realSeconds, double notBeyond)
{
    if (!m_state.isPlaying || realSeconds <= 0.0) {
        return;
    }
    const double real = std::min(realSeconds, kLongestPlayStep);
    const double step = real * m_state.speed;
    const double taken = std::clamp(notBeyond - m_state.seconds, 0.0, step);
    m_state.seconds += taken;
    m_pace += (taken / step - m_pace) * std::min(1.0, real / kPaceSeconds);
    Q_EMIT timeChanged(m_state.seconds);
}

} // namespace crowd::widgets
