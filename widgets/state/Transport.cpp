// SPDX-License-Identifier: MIT
#include "widgets/state/Transport.h"

#include <algorithm>

namespace crowd::widgets {

namespace {

constexpr double kLongestPlayStep = 0.25;
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
    Q_EMIT stateChanged(m_state);
}

void Transport::advance(double realSeconds, double notBeyond)
{
    if (!m_state.isPlaying || realSeconds <= 0.0) {
        return;
    }
    const double wanted = m_state.seconds + std::min(realSeconds, kLongestPlayStep) * m_state.speed;
    m_state.seconds = std::max(m_state.seconds, std::min(wanted, notBeyond));
    Q_EMIT timeChanged(m_state.seconds);
}

} // namespace crowd::widgets
