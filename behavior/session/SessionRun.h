// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

#include "behavior/session/MotionCache.h"
#include "behavior/session/MotionReader.h"
#include "behavior/session/RecordedSession.h"
#include "behavior/session/RunJournal.h"
#include "behavior/session/SessionPlayer.h"

namespace crowd::behavior {

inline constexpr double kTimeSlack = 1e-9; ///< seconds; sums of steps are not exact

/// One session of a player and its thread, with all that passes between that and the player.
struct SessionPlayer::Run
{
    using Order = std::function<void(Run& run)>;
    /// That the run goes on from an earlier step.
    struct Take
    {
        std::uint64_t number = 0;        ///< of takes that were asked for
        std::uint64_t step = 0;          ///< from which it goes on
        std::uint64_t forgottenFrom = 0; ///< what was told at this step or later
    };
    /// One that is being computed.
    struct Taking
    {
        double seconds = 0.0; ///< at which it goes on
        double share = 0.0;
    };

    // The thread's, once it runs.
    std::unique_ptr<RecordedSession> recorded; ///< null: a take was given up for the next one
    std::uint64_t steps = 0;                   ///< of the session, also where there is none
    std::unique_ptr<RunJournal> journal;       ///< null: it is over
    EarlierSteps earlier;                      ///< of the run before
    std::stop_token token;
    std::shared_ptr<const WalkSurface> surface; ///< that it was told last
    std::optional<std::uint64_t> surfaceStep;   ///< at which that was; nothing: it began with it

    std::function<void()> published;
    double startSeconds = 0.0;
    std::uint32_t stepsPerSecond = 30;
    std::atomic<std::uint64_t> takes{0}; ///< that were asked for
    std::atomic<bool> isOver{false};     ///< the last that the thread does
    mutable std::mutex mutex;
    std::condition_variable_any wake;
    // Under the mutex.
    std::vector<Order> orders;
    double wanted = 0.0;
    std::deque<SessionPosePtr> poses; ///< the latest ones, ascending
    Report report;
    SessionTally tally;
    std::vector<RuleFired> log;
    model::Timeline performed; ///< by perform()
    bool isWhole = true;       ///< the journal
    std::optional<Taking> taking;
    /// All steps but the last one, which an edit may still change.
    std::shared_ptr<MotionCache> cache = std::make_shared<MotionCache>();
    std::shared_ptr<MotionReader> reader = std::make_shared<MotionReader>(cache); ///< the picture's

    std::jthread thread; ///< last: ends first

    Run(const model::Scene& scene, double seconds, std::shared_ptr<const WalkSurface> ground);
    Run(const model::Scene& scene, RunBeginning beginning,
        std::shared_ptr<const WalkSurface> ground);
    void serve();
    void act(RunJournal::Act act, const model::Scene* scene = nullptr);
    void walkOn(std::shared_ptr<const WalkSurface> ground);
    void take(const Take& wish);
    void publish();
    void release();
    [[nodiscard]] std::pair<SessionPosePtr, SessionPosePtr> readyAround(double seconds,
                                                                        bool isLast) const;

private:
    Run(std::unique_ptr<RunJournal> told, double seconds);
    void copyEarlier();
    [[nodiscard]] std::shared_ptr<MotionCache> cacheAfterEarlier();
    [[nodiscard]] bool isStepWanted() const;
    [[nodiscard]] bool isGivenUp(const Take& wish) const;
    [[nodiscard]] bool replay(RecordedSession& again, const Take& wish);
    void goOnWith(std::unique_ptr<RecordedSession> again);
};

} // namespace crowd::behavior
