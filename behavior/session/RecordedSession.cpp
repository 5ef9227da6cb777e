// SPDX-License-Identifier: MIT
#include "behavior/session/RecordedSession.h"

namespace crowd::behavior {

RecordedSession::RecordedSession(std::unique_ptr<Session> session,
                                 std::shared_ptr<MotionCache> kept)
    : m_session(std::move(session)), m_kept(std::move(kept)), m_reader(m_kept)
{
}

const SessionPosePtr& RecordedSession::take()
{
    SessionPosePtr pose = m_session->pose();
    if (m_last && m_last->step != pose->step) {
        keep(); // nobody has done so
        m_before = std::move(m_last);
        m_isBeforeKept = std::exchange(m_isLastKept, false);
    }
    m_last = std::move(pose);
    return m_last;
}

void RecordedSession::keep()
{
    if (m_kept && m_before && !m_isBeforeKept) {
        m_kept->add(m_before);
    }
    m_isBeforeKept = true;
}

void RecordedSession::advance()
{
    step();
    take();
    keep();
}

std::pair<SessionPosePtr, SessionPosePtr> RecordedSession::around(double seconds)
{
    if (seconds >= m_last->seconds || !m_before) {
        return {m_last, m_last};
    }
    if (seconds >= m_before->seconds) {
        return {m_before, m_last};
    }
    if (!m_kept || seconds < m_kept->extent().first) {
        return {};
    }
    return m_reader.around(seconds);
}

const std::shared_ptr<MotionCache>& RecordedSession::wholeMotion()
{
    keep();
    if (m_kept && m_last && !m_isLastKept) {
        m_kept->add(m_last);
        m_isLastKept = true;
    }
    return m_kept;
}

void RecordedSession::keepAfter(std::shared_ptr<MotionCache> kept)
{
    m_kept = std::move(kept);
    m_reader = MotionReader(m_kept);
}

} // namespace crowd::behavior
