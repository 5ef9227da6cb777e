// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "behavior/session/Session.h"

namespace crowd::behavior {

class MotionCache;
struct RunBeginning;

/// Runs a session on a thread of its own, a little ahead of the picture, so that a slow step never
/// makes anybody wait. All functions are called by one thread, which shows the picture and never
/// waits for a step, not even to stop; edits and events take effect at the next step that is
/// computed.
class SessionPlayer
{
public:
    struct Report
    {
        std::vector<Problem> problems;
        std::map<model::RuleId, std::uint64_t> fired;
    };

    /// `published` is called on the session's thread after every step.
    explicit SessionPlayer(std::function<void()> published);
    ~SessionPlayer(); ///< waits for the step that is under way
    SessionPlayer(const SessionPlayer&) = delete;
    SessionPlayer& operator=(const SessionPlayer&) = delete;

    /// `seconds` is what the transport shows as it begins.
    void start(const model::Scene& scene, double seconds = 0.0,
               std::shared_ptr<const WalkSurface> surface = nullptr);
    /// The same, of people as they were at a moment of an earlier run; what was shown before that
    /// is copied first, and kept with what comes. Until then nothing later is shown; see
    /// takenShare().
    void start(const model::Scene& scene, RunBeginning beginning,
               std::shared_ptr<const WalkSurface> surface);
    /// The session is gone, as soon as its thread notices; the scene is as it was.
    void stop();
    [[nodiscard]] bool isRunning() const { return m_run != nullptr; }

    /// The scene was edited; see Session::adopt().
    void adopt(const model::Scene& scene, bool arePosesKept = false);
    void adopt(const model::Scene& scene, const model::ChangeOver& change);
    void setSurface(std::shared_ptr<const WalkSurface> surface);
    /// See Session::perform().
    void perform(const model::Mark& mark);

    /// What comes after the step that is shown at this time is forgotten: the run goes on from
    /// there, and what it is told next happens there. All until then is computed once more on its
    /// thread, from what it was told, and is the same bit for bit; until that is done nothing later
    /// is shown. False: too much was edited to be told once more, and nothing happens.
    bool takeFrom(double seconds);
    /// The same from the last step that is earlier than this time, so that what happens then can
    /// be another.
    bool takeBefore(double seconds);
    /// The share that is computed of what takes until then; nothing: it is done.
    [[nodiscard]] std::optional<double> takenShare() const;

    /// Steps are wanted up to this time, seconds.
    void request(double seconds);
    /// A step is wanted that is not done: what is told now is heard some step after the last.
    [[nodiscard]] bool isBehind() const;
    /// Time of the last step that is done.
    [[nodiscard]] double available() const;
    /// Time of the earliest step that is known still. All are kept as long as they fit a budget of
    /// memory and disk; then the earliest go first.
    [[nodiscard]] double first() const;
    /// All steps that are known still but the last one, for readers on any thread; null: no run.
    [[nodiscard]] std::shared_ptr<MotionCache> motion() const;
    /// Puts people where they are at frame.seconds, as far as that has been computed.
    void pose(model::CrowdFrame& frame) const;
    /// Of the step that is shown at a time; null before the first one.
    [[nodiscard]] SessionPosePtr poseAt(double seconds) const;
    [[nodiscard]] Report report() const;
    /// People are counted once more, before the next step; `published` tells when that is done.
    void askTally();
    /// As last counted; at the beginning they are.
    [[nodiscard]] SessionTally tally() const;
    [[nodiscard]] std::vector<RuleFired> takeLog();
    /// Marks with an id that perform() was asked for and that have been heard since the last call,
    /// each with the time at which that was: performed at that time in another run of the same
    /// scene, they do the same.
    [[nodiscard]] model::Timeline takePerformed();

private:
    struct Run;

    void begin(std::unique_ptr<Run> run);
    void give(std::function<void(Run& run)> order);
    bool take(std::uint64_t step, std::uint64_t forgottenFrom);
    [[nodiscard]] std::pair<SessionPosePtr, SessionPosePtr> posesAround(double seconds) const;

    std::function<void()> m_published;
    std::unique_ptr<Run> m_run;                ///< null: none
    std::vector<std::unique_ptr<Run>> m_ended; ///< until their threads have ended
    Report m_lastReport;                       ///< of the run before
    SessionTally m_lastTally;
};

} // namespace crowd::behavior
