// SPDX-License-Identifier: MIT
#include "behavior/session/SessionPlayer.h"

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

#include "behavior/session/SessionRun.h"

namespace crowd::behavior {

namespace {

constexpr double kPartOfStep = 1e-6; ///< by which times of steps are not exact

} // namespace

SessionPlayer::SessionPlayer(std::function<void()> published) : m_published(std::move(published)) {}

SessionPlayer::~SessionPlayer()
{
    stop();
}

void SessionPlayer::start(const model::Scene& scene, double seconds,
                          std::shared_ptr<const WalkSurface> surface)
{
    begin(std::make_unique<Run>(scene, seconds, std::move(surface)));
}

void SessionPlayer::start(const model::Scene& scene, RunBeginning beginning,
                          std::shared_ptr<const WalkSurface> surface)
{
    begin(std::make_unique<Run>(scene, std::move(beginning), std::move(surface)));
}

void SessionPlayer::begin(std::unique_ptr<Run> next)
{
    stop();
    m_run = std::move(next);
    Run& run = *m_run;
    run.published = m_published;
    run.thread = std::jthread([&run](std::stop_token token) {
        run.token = std::move(token);
        run.serve();
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
        run.act([copy, arePosesKept](Session& session) { session.adopt(*copy, arePosesKept); },
                copy.get());
    });
}

void SessionPlayer::adopt(const model::Scene& scene, const model::ChangeOver& change)
{
    give([copy = std::make_shared<const model::Scene>(scene), change](Run& run) {
        run.act([copy, change](Session& session) { session.adopt(*copy, change); }, copy.get());
    });
}

void SessionPlayer::setSurface(std::shared_ptr<const WalkSurface> surface)
{
    give([surface = std::move(surface)](Run& run) { run.walkOn(surface); });
}

void SessionPlayer::perform(const model::Mark& mark)
{
    give([mark](Run& run) {
        model::Mark done = mark;
        done.seconds = run.startSeconds + static_cast<double>(run.steps) / run.stepsPerSecond;
        run.act([done](Session& session) { session.perform(done); });
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

bool SessionPlayer::take(std::uint64_t step, std::uint64_t forgottenFrom)
{
    {
        const std::scoped_lock lock(m_run->mutex);
        if (!m_run->isWhole) {
            return false;
        }
        const Run::Take wish{++m_run->takes, step, forgottenFrom};
        m_run->wanted = m_run->startSeconds + static_cast<double>(step) / m_run->stepsPerSecond;
        m_run->taking = Run::Taking{m_run->wanted, 0.0};
        m_run->orders.emplace_back([wish](Run& run) { run.take(wish); });
    }
    m_run->wake.notify_all();
    return true;
}

bool SessionPlayer::takeFrom(double seconds)
{
    if (!m_run) {
        return false;
    }
    const double since = std::min(seconds, available()) - m_run->startSeconds;
    const auto step =
        static_cast<std::uint64_t>(std::max(0.0, since * m_run->stepsPerSecond + kPartOfStep));
    return take(step, step + 1);
}

bool SessionPlayer::takeBefore(double seconds)
{
    if (!m_run) {
        return false;
    }
    const double since = std::min(seconds, available()) - m_run->startSeconds;
    const double steps = std::ceil(since * m_run->stepsPerSecond - kPartOfStep);
    const auto next = static_cast<std::uint64_t>(std::max(0.0, steps)); // told then: too late
    return take(next > 0 ? next - 1 : 0, next);
}

std::optional<double> SessionPlayer::takenShare() const
{
    if (!m_run) {
        return std::nullopt;
    }
    const std::scoped_lock lock(m_run->mutex);
    return m_run->taking ? std::optional(m_run->taking->share) : std::nullopt;
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

bool SessionPlayer::isBehind() const
{
    if (!m_run) {
        return false;
    }
    const std::scoped_lock lock(m_run->mutex);
    return m_run->poses.back()->seconds + kTimeSlack < m_run->wanted;
}

double SessionPlayer::available() const
{
    if (!m_run) {
        return 0.0;
    }
    const std::scoped_lock lock(m_run->mutex);
    return m_run->taking ? m_run->taking->seconds : m_run->poses.back()->seconds;
}

double SessionPlayer::first() const
{
    if (!m_run) {
        return 0.0;
    }
    const std::scoped_lock lock(m_run->mutex);
    const MotionCache::Extent kept = m_run->cache->extent();
    const double ready = m_run->poses.front()->seconds;
    return kept.steps > 0 ? std::min(kept.first, ready) : ready;
}

std::shared_ptr<MotionCache> SessionPlayer::motion() const
{
    if (!m_run) {
        return nullptr;
    }
    const std::scoped_lock lock(m_run->mutex);
    return m_run->cache;
}

std::pair<SessionPosePtr, SessionPosePtr> SessionPlayer::posesAround(double seconds) const
{
    if (!m_run) {
        return {};
    }
    std::shared_ptr<MotionReader> reader;
    bool isLast = false; // what comes after it is being forgotten
    {
        const std::scoped_lock lock(m_run->mutex);
        if (m_run->taking && seconds >= m_run->taking->seconds) {
            seconds = m_run->taking->seconds + kTimeSlack;
            isLast = true;
        }
        if (seconds >= m_run->poses.front()->seconds) {
            return m_run->readyAround(seconds, isLast);
        }
        reader = m_run->reader;
    }
    auto kept = reader->around(seconds);
    if (kept.first) {
        return {kept.first, isLast ? kept.first : kept.second};
    }
    // Nothing is kept yet, or it is damaged.
    const std::scoped_lock lock(m_run->mutex);
    return m_run->readyAround(seconds, isLast);
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
        if (!run.recorded) {
            return; // it is asked anew
        }
        SessionTally tally = run.recorded->session().tally();
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
    if (m_run->taking) {
        return {}; // some of it is to be forgotten
    }
    return std::exchange(m_run->log, {});
}

} // namespace crowd::behavior
