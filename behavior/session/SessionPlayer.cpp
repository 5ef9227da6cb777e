// SPDX-License-Identifier: MIT
#include "behavior/session/SessionPlayer.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace crowd::behavior {

namespace {

constexpr double kKeptSeconds = 1.2; ///< more than anybody runs ahead
constexpr double kSlack = 1e-9;      ///< seconds; sums of steps are not exact
constexpr std::size_t kMaxLog = 20000;

} // namespace

SessionPlayer::SessionPlayer(std::function<void()> published) : m_published(std::move(published)) {}

SessionPlayer::~SessionPlayer()
{
    stop();
}

void SessionPlayer::start(const model::Scene& scene, double seconds,
                          std::shared_ptr<const WalkSurface> surface)
{
    stop();
    m_session = std::make_unique<Session>(scene);
    m_session->setStart(seconds);
    if (surface) {
        m_session->setSurface(std::move(surface));
    }
    m_poses = {m_session->pose()};
    m_wanted = seconds;
    m_report = {m_session->problems(), {}, 0.0};
    m_tally = m_session->tally();
    m_thread = std::jthread([this](std::stop_token token) { run(std::move(token)); });
}

void SessionPlayer::stop()
{
    if (isRunning()) {
        m_thread.request_stop();
        m_wake.notify_all();
        m_thread.join();
        m_thread = {};
    }
    m_session.reset();
    m_orders.clear();
    m_poses.clear();
    m_log.clear();
}

void SessionPlayer::give(Order order)
{
    if (!isRunning()) {
        return;
    }
    {
        const std::scoped_lock lock(m_mutex);
        m_orders.push_back(std::move(order));
    }
    m_wake.notify_all();
}

void SessionPlayer::adopt(const model::Scene& scene, bool arePosesKept)
{
    // A copy without what a session does not look at: stages are large names only, columns shared.
    give([copy = std::make_shared<const model::Scene>(scene), arePosesKept](Session& session) {
        session.adopt(*copy, arePosesKept);
    });
}

void SessionPlayer::setSurface(std::shared_ptr<const WalkSurface> surface)
{
    give([surface = std::move(surface)](Session& session) { session.setSurface(surface); });
}

void SessionPlayer::send(const std::string& event, float payload,
                         std::vector<model::IndividualId> ids)
{
    give([event, payload, ids = std::move(ids)](Session& session) {
        session.send(event, payload, ids);
    });
}

void SessionPlayer::sendTagged(const std::string& event, float payload, std::uint8_t tag)
{
    give([event, payload, tag](Session& session) { session.sendTagged(event, payload, tag); });
}

void SessionPlayer::request(double seconds)
{
    {
        const std::scoped_lock lock(m_mutex);
        if (seconds <= m_wanted) {
            return;
        }
        m_wanted = seconds;
    }
    m_wake.notify_all();
}

double SessionPlayer::available() const
{
    const std::scoped_lock lock(m_mutex);
    return m_poses.empty() ? 0.0 : m_poses.back()->seconds;
}

std::pair<SessionPosePtr, SessionPosePtr> SessionPlayer::posesAround(double seconds) const
{
    const std::scoped_lock lock(m_mutex);
    if (m_poses.empty()) {
        return {};
    }
    const auto next = std::ranges::find_if(
        m_poses, [&](const SessionPosePtr& pose) { return pose->seconds > seconds; });
    const SessionPosePtr after = next == m_poses.end() ? m_poses.back() : *next;
    return {next == m_poses.begin() || next == m_poses.end() ? after : *std::prev(next), after};
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

std::vector<model::IndividualId> SessionPlayer::lit() const
{
    const std::scoped_lock lock(m_mutex);
    return m_poses.empty() ? std::vector<model::IndividualId>() : m_poses.back()->lit;
}

SessionPlayer::Report SessionPlayer::report() const
{
    const std::scoped_lock lock(m_mutex);
    return m_report;
}

void SessionPlayer::askTally()
{
    give([this](Session& session) {
        SessionTally tally = session.tally();
        const std::scoped_lock lock(m_mutex);
        m_tally = std::move(tally);
    });
}

SessionTally SessionPlayer::tally() const
{
    const std::scoped_lock lock(m_mutex);
    return m_tally;
}

std::vector<RuleFired> SessionPlayer::takeLog()
{
    const std::scoped_lock lock(m_mutex);
    return std::exchange(m_log, {});
}

void SessionPlayer::publish(Session& session, double stepMs)
{
    SessionPosePtr pose = session.pose();
    std::vector<Problem> problems = session.problems();
    const std::vector<RuleFired> fired = session.rules().takeLog();
    const std::scoped_lock lock(m_mutex);
    if (!m_poses.empty() && m_poses.back()->step == pose->step) {
        m_poses.pop_back(); // the same step, after an edit
    }
    m_poses.push_back(std::move(pose));
    while (m_poses.front()->seconds < m_poses.back()->seconds - kKeptSeconds) {
        m_poses.pop_front();
    }
    m_report = {std::move(problems), session.rules().counts(), stepMs};
    if (m_log.size() < kMaxLog) {
        m_log.insert(m_log.end(), fired.begin(), fired.end());
    }
}

void SessionPlayer::run(std::stop_token token)
{
    Session& session = *m_session;
    while (!token.stop_requested()) {
        std::vector<Order> orders;
        bool isStepWanted = false;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, token,
                        [&] { return !m_orders.empty() || session.seconds() + kSlack < m_wanted; });
            orders = std::exchange(m_orders, {});
            isStepWanted = session.seconds() + kSlack < m_wanted;
        }
        if (token.stop_requested()) {
            return;
        }
        for (const Order& order : orders) {
            order(session);
        }
        const auto begin = std::chrono::steady_clock::now();
        if (isStepWanted) {
            session.step();
        }
        const std::chrono::duration<double, std::milli> time =
            std::chrono::steady_clock::now() - begin;
        publish(session, time.count());
        m_published();
    }
}

} // namespace crowd::behavior
