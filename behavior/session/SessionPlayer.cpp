// SPDX-License-Identifier: MIT
#include "behavior/session/SessionPlayer.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

#include "behavior/session/MotionCache.h"
#include "behavior/session/MotionReader.h"

namespace crowd::behavior {

namespace {

constexpr double kReadySeconds = 1.2; ///< before the last step: they need not be unpacked
constexpr double kSlack = 1e-9;       ///< seconds; sums of steps are not exact
constexpr std::size_t kMaxLog = 200'000;

} // namespace

/// One session and its thread, with all that passes between that and the player.
struct SessionPlayer::Run
{
    using Order = std::function<void(Run& run)>;

    std::unique_ptr<Session> session; ///< the thread's, once it runs
    std::function<void()> published;
    mutable std::mutex mutex;
    std::condition_variable_any wake;
    std::atomic<bool> isOver{false}; ///< the last that the thread does
    // Under the mutex.
    std::vector<Order> orders;
    double wanted = 0.0;
    std::deque<SessionPosePtr> poses; ///< the latest ones, ascending
    Report report;
    SessionTally tally;
    std::vector<RuleFired> log;
    model::Timeline performed; ///< by perform()

    /// All steps but the last one, which an edit may still change.
    std::shared_ptr<MotionCache> cache = std::make_shared<MotionCache>();
    std::unique_ptr<MotionReader> reader = std::make_unique<MotionReader>(cache); ///< the picture's
    std::jthread thread; ///< last: ends first

    void serve(const std::stop_token& token);
    [[nodiscard]] SessionPosePtr publish();
    void release();
    [[nodiscard]] std::pair<SessionPosePtr, SessionPosePtr> readyAround(double seconds) const;
};

void SessionPlayer::Run::serve(const std::stop_token& token)
{
    while (!token.stop_requested()) {
        std::vector<Order> taken;
        bool isStepWanted = false;
        {
            std::unique_lock lock(mutex);
            wake.wait(lock, token,
                      [&] { return !orders.empty() || session->seconds() + kSlack < wanted; });
            taken = std::exchange(orders, {});
            isStepWanted = session->seconds() + kSlack < wanted;
        }
        for (const Order& order : taken) {
            if (token.stop_requested()) {
                return;
            }
            order(*this);
        }
        if (token.stop_requested()) {
            return;
        }
        if (isStepWanted) {
            session->step();
        }
        if (!token.stop_requested()) {
            const SessionPosePtr before = publish();
            published();
            if (before) {
                cache->add(before); // nobody waits for that
            }
        }
    }
}

/// Whoever ended it may not ask again for long: it holds the scene's characters and stages.
void SessionPlayer::Run::release()
{
    session.reset();
    cache.reset();
    reader.reset();
    const std::scoped_lock lock(mutex);
    orders.clear();
    poses.clear();
}

/// The step before, where this is another one: nothing changes it any more.
SessionPosePtr SessionPlayer::Run::publish()
{
    SessionPosePtr pose = session->pose();
    std::vector<Problem> problems = session->problems();
    const std::vector<RuleFired> fired = session->rules().takeLog();
    const std::scoped_lock lock(mutex);
    SessionPosePtr before = poses.back();
    if (before->step == pose->step) {
        poses.pop_back(); // the same step, after an edit
        before = nullptr;
    }
    poses.push_back(std::move(pose));
    while (poses.size() > 1 && poses[1]->seconds <= poses.back()->seconds - kReadySeconds) {
        poses.pop_front();
    }
    report = {std::move(problems), session->rules().counts()};
    if (log.size() < kMaxLog) {
        log.insert(log.end(), fired.begin(), fired.end());
    }
    return before;
}

SessionPlayer::SessionPlayer(std::function<void()> published) : m_published(std::move(published)) {}

SessionPlayer::~SessionPlayer()
{
    stop();
}

void SessionPlayer::start(const model::Scene& scene, double seconds,
                          std::shared_ptr<const WalkSurface> surface)
{
    stop();
    m_run = std::make_unique<Run>();
    Run& run = *m_run;
    run.published = m_published;
    run.session = std::make_unique<Session>(scene);
    run.session->setStart(seconds);
    if (surface) {
        run.session->setSurface(std::move(surface));
    }
    run.poses = {run.session->pose()};
    run.wanted = seconds;
    run.report = {run.session->problems(), {}};
    run.tally = run.session->tally();
    run.thread = std::jthread([&run](const std::stop_token& token) {
        run.serve(token);
        run.release();
        run.isOver = true;
    });
}

void SessionPlayer::stop()
{
    if (m_run) {
        m_lastReport = report();
        m_lastTally = tally();
        m_run->thread.request_stop();
        m_ended.push_back(std::move(m_run));
    }
    std::erase_if(m_ended, [](const auto& run) { return run->isOver.load(); });
}

void SessionPlayer::give(std::function<void(Run& run)> order)
{
    if (!m_run) {
        return;
    }
    {
        const std::scoped_lock lock(m_run->mutex);
        m_run->orders.push_back(std::move(order));
    }
    m_run->wake.notify_all();
}

void SessionPlayer::adopt(const model::Scene& scene, bool arePosesKept)
{
    // A snapshot: columns and assets are shared, not copied.
    give([copy = std::make_shared<const model::Scene>(scene), arePosesKept](Run& run) {
        run.session->adopt(*copy, arePosesKept);
    });
}

void SessionPlayer::adopt(const model::Scene& scene, const model::ChangeOver& change)
{
    give([copy = std::make_shared<const model::Scene>(scene), change](Run& run) {
        run.session->adopt(*copy, change);
    });
}

void SessionPlayer::setSurface(std::shared_ptr<const WalkSurface> surface)
{
    give([surface = std::move(surface)](Run& run) { run.session->setSurface(surface); });
}

void SessionPlayer::perform(const model::Mark& mark)
{
    give([mark](Run& run) {
        model::Mark done = mark;
        done.seconds = run.session->seconds();
        run.session->perform(done);
        const std::scoped_lock lock(run.mutex);
        if (done.id != 0) {
            run.performed.push_back(std::move(done));
        }
    });
}

model::Timeline SessionPlayer::takePerformed()
{
    if (!m_run) {
        return {};
    }
    const std::scoped_lock lock(m_run->mutex);
    return std::exchange(m_run->performed, {});
}

void SessionPlayer::request(double seconds)
{
    if (!m_run) {
        return;
    }
    {
        const std::scoped_lock lock(m_run->mutex);
        if (seconds <= m_run->wanted) {
            return;
        }
        m_run->wanted = seconds;
    }
    m_run->wake.notify_all();
}

double SessionPlayer::available() const
{
    if (!m_run) {
        return 0.0;
    }
    const std::scoped_lock lock(m_run->mutex);
    return m_run->poses.back()->seconds;
}

double SessionPlayer::first() const
{
    if (!m_run) {
        return 0.0;
    }
    const MotionCache::Extent kept = m_run->reader->cache().extent();
    const std::scoped_lock lock(m_run->mutex);
    const double ready = m_run->poses.front()->seconds;
    return kept.steps > 0 ? std::min(kept.first, ready) : ready;
}

std::shared_ptr<MotionCache> SessionPlayer::motion() const
{
    return m_run ? m_run->cache : nullptr;
}

std::pair<SessionPosePtr, SessionPosePtr> SessionPlayer::posesAround(double seconds) const
{
    if (!m_run) {
        return {};
    }
    {
        const std::scoped_lock lock(m_run->mutex);
        if (seconds >= m_run->poses.front()->seconds) {
            return m_run->readyAround(seconds);
        }
    }
    auto kept = m_run->reader->around(seconds);
    if (kept.first) {
        return kept;
    }
    // Nothing is kept yet, or it is damaged.
    const std::scoped_lock lock(m_run->mutex);
    return m_run->readyAround(seconds);
}

/// Of those that need not be unpacked; under the mutex.
std::pair<SessionPosePtr, SessionPosePtr> SessionPlayer::Run::readyAround(double seconds) const
{
    const auto next = std::ranges::find_if(
        poses, [&](const SessionPosePtr& pose) { return pose->seconds > seconds; });
    const SessionPosePtr after = next == poses.end() ? poses.back() : *next;
    return {next == poses.begin() || next == poses.end() ? after : *std::prev(next), after};
}

SessionPosePtr SessionPlayer::poseAt(double seconds) const
{
    return posesAround(seconds).first;
}

void SessionPlayer::pose(model::CrowdFrame& frame) const
{
    const auto [before, after] = posesAround(frame.seconds);
    if (before) {
        applyPose(*before, *after, frame);
    }
}

SessionPlayer::Report SessionPlayer::report() const
{
    if (!m_run) {
        return m_lastReport;
    }
    const std::scoped_lock lock(m_run->mutex);
    return m_run->report;
}

void SessionPlayer::askTally()
{
    give([](Run& run) {
        SessionTally tally = run.session->tally();
        const std::scoped_lock lock(run.mutex);
        run.tally = std::move(tally);
    });
}

SessionTally SessionPlayer::tally() const
{
    if (!m_run) {
        return m_lastTally;
    }
    const std::scoped_lock lock(m_run->mutex);
    return m_run->tally;
}

std::vector<RuleFired> SessionPlayer::takeLog()
{
    if (!m_run) {
        return {};
    }
    const std::scoped_lock lock(m_run->mutex);
    return std::exchange(m_run->log, {});
}

} // namespace crowd::behavior
