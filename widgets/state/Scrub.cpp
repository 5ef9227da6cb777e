// SPDX-License-Identifier: MIT
#include "widgets/state/Scrub.h"

#include <algorithm>
#include <utility>

namespace crowd::widgets {

void Scrub::begin()
{
    m_isHeld = true;
    m_playedBefore = m_state.transport().isPlaying();
    m_state.transport().setPlaying(false);
}

void Scrub::end()
{
    if (std::exchange(m_isHeld, false)) {
        m_state.transport().setPlaying(m_playedBefore);
    }
}

double Scrub::first() const
{
    return std::min(m_state.session().firstSeconds(), last());
}

double Scrub::last() const
{
    return std::max(m_state.session().liveSeconds(), m_state.transport().seconds());
}

void Scrub::show(double seconds)
{
    // Without behaviour a moment is what it is: nothing has to be played for it.
    const bool isFree = !m_state.session().isPosed() && !m_state.scene().hasBehaviour();
    const double latest = isFree ? std::max(seconds, last()) : last();
    m_state.transport().setSeconds(std::clamp(seconds, first(), latest));
    if (seconds > latest) {
        m_state.director().preview(seconds);
    }
}

} // namespace crowd::widgets
