// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

#include "behavior/session/MotionCache.h"
#include "behavior/session/MotionReader.h"
#include "behavior/session/Session.h"

namespace crowd::behavior {

/// A session and the steps it has made: what the window's player, pictures, movies and scripts
/// step, so that each can show an earlier time again. The last step is not kept until the next is
/// there: an edit may still change it. One thread.
class RecordedSession
{
public:
    /// What is kept goes after what the cache has; null: nothing is kept.
    RecordedSession(std::unique_ptr<Session> session, std::shared_ptr<MotionCache> kept);

    [[nodiscard]] Session& session() const { return *m_session; }

    /// A step; nothing is taken of it yet.
    void step() { m_session->step(); }
    /// Everybody now: after a step, or where the session was told something at the same one.
    const SessionPosePtr& take();
    /// The step before the one that was taken last, if it is another, is kept. May come later than
    /// who waits for that one.
    void keep();
    /// All of it at once.
    void advance();

    /// As taken last; null: nothing was.
    [[nodiscard]] const SessionPosePtr& last() const { return m_last; }
    /// Of the step before that; null: there is none.
    [[nodiscard]] const SessionPosePtr& before() const { return m_before; }
    /// The steps around a time that is not later than the last; null: they are not known any more.
    [[nodiscard]] std::pair<SessionPosePtr, SessionPosePtr> around(double seconds);
    /// All steps but the last one, for readers on any thread; null: none is kept.
    [[nodiscard]] const std::shared_ptr<MotionCache>& motion() const { return m_kept; }
    /// The same with the last one, which no edit changes any more.
    [[nodiscard]] const std::shared_ptr<MotionCache>& wholeMotion();
    /// From now on they go after what that cache has.
    void keepAfter(std::shared_ptr<MotionCache> kept);

private:
    std::unique_ptr<Session> m_session;
    std::shared_ptr<MotionCache> m_kept;
    MotionReader m_reader;
    SessionPosePtr m_before; ///< of another step than the last; null: there is none
    SessionPosePtr m_last;
    bool m_isBeforeKept = true; ///< or there is none
    bool m_isLastKept = false;
};

} // namespace crowd::behavior
