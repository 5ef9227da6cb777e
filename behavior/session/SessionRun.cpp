// SPDX-License-Identifier: MIT
#include "behavior/session/SessionRun.h"

#include <algorithm>

namespace crowd::behavior {

namespace {

constexpr double kReadySeconds = 1.2; ///< before the last step: they need not be unpacked
constexpr std::size_t kMaxLog = 200'000;
constexpr std::uint64_t kStepsSaid = 30; ///< of a take: then its share is shown

} // namespace

SessionPlayer::Run::Run(const model::Scene& scene, double seconds,
                        std::shared_ptr<const WalkSurface> ground)
    : Run(std::make_unique<RunJournal>(scene, seconds, std::move(ground)), seconds)
{
}

SessionPlayer::Run::Run(const model::Scene& scene, RunBeginning beginning,
                        std::shared_ptr<const WalkSurface> ground)
    : Run(std::make_unique<RunJournal>(scene, beginning.now->seconds, std::move(ground),
                                       RunBeginning{beginning.before, beginning.now, {}}),
          beginning.now->seconds)
{
    earlier = std::move(beginning.earlier);
    taking = Taking{startSeconds, 0.0};
}

SessionPlayer::Run::Run(std::unique_ptr<RunJournal> told, double seconds)
    : journal(std::move(told)), startSeconds(seconds), wanted(seconds)
{
    recorded = std::make_unique<RecordedSession>(journal->begin(), cache);
    const Session& session = recorded->session();
    stepsPerSecond = session.stepsPerSecond();
    poses = {recorded->take()};
    report = {session.problems(), {}};
    tally = session.tally();
}

bool SessionPlayer::Run::isStepWanted() const
{
    return recorded && recorded->session().seconds() + kTimeSlack < wanted;
}

/// A cache that has what was shown before the run began, if anything was.
std::shared_ptr<MotionCache> SessionPlayer::Run::cacheAfterEarlier()
{
    auto kept = std::make_shared<MotionCache>();
    if (!earlier) {
        return kept;
    }
    std::uint64_t count = 0;
    std::optional<double> first;
    earlier([&](const SessionPosePtr& pose) {
        kept->add(pose);
        first = first.value_or(pose->seconds);
        if (++count % kStepsSaid == 0) {
            const double share =
                (pose->seconds - *first) / std::max(startSeconds - *first, kTimeSlack);
            {
                const std::scoped_lock lock(mutex);
                taking = taking ? std::optional(Taking{taking->seconds, share}) : std::nullopt;
            }
            published();
        }
        return !token.stop_requested();
    });
    return kept;
}

/// Before anything is told and made.
void SessionPlayer::Run::copyEarlier()
{
    if (!earlier) {
        return;
    }
    auto kept = cacheAfterEarlier();
    auto next = std::make_shared<MotionReader>(kept);
    recorded->keepAfter(kept);
    {
        const std::scoped_lock lock(mutex);
        cache = std::move(kept);
        reader = std::move(next);
        if (takes == 0) {
            taking.reset();
        }
    }
    published();
}

void SessionPlayer::Run::serve()
{
    copyEarlier();
    while (!token.stop_requested()) {
        std::vector<Order> taken;
        {
            std::unique_lock lock(mutex);
            wake.wait(lock, token, [&] { return !orders.empty() || isStepWanted(); });
            taken = std::exchange(orders, {});
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
        bool isWanted = false;
        {
            const std::scoped_lock lock(mutex);
            isWanted = isStepWanted();
        }
        if (isWanted) {
            recorded->step();
            steps = recorded->session().steps();
        }
        if (recorded && !token.stop_requested()) {
            publish();
            published();
            recorded->keep(); // nobody waits for that
        }
    }
}

/// Whoever ended it may not ask again for long: it holds the scene's characters and stages.
void SessionPlayer::Run::release()
{
    recorded.reset();
    journal.reset();
    earlier = nullptr;
    surface.reset();
    const std::scoped_lock lock(mutex);
    cache.reset();
    reader.reset();
    orders.clear();
    poses.clear();
}

/// Tells the session something that is to be told once more where it is taken from later on.
void SessionPlayer::Run::act(RunJournal::Act act, const model::Scene* scene)
{
    if (recorded) {
        act(recorded->session());
    }
    if (scene != nullptr) {
        journal->add(steps, std::move(act), *scene);
    } else {
        journal->add(steps, std::move(act));
    }
    if (recorded) { // else that is made of it
        journal->limit();
    }
    const std::scoped_lock lock(mutex);
    isWhole = journal->isWhole();
}

void SessionPlayer::Run::walkOn(std::shared_ptr<const WalkSurface> ground)
{
    surface = std::move(ground);
    surfaceStep = steps;
    act([told = surface](Session& each) { each.setSurface(told); });
}

/// For a later one, or since all ends.
bool SessionPlayer::Run::isGivenUp(const Take& wish) const
{
    return token.stop_requested() || takes != wish.number;
}

/// False: given up.
bool SessionPlayer::Run::replay(RecordedSession& again, const Take& wish)
{
    Session& session = again.session();
    while (!isGivenUp(wish)) {
        journal->tell(session);
        (void)session.rules().takeLog(); // known already
        again.take();
        if (session.steps() >= wish.step) {
            return true;
        }
        again.step();
        {
            const std::scoped_lock lock(mutex);
            taking->share = static_cast<double>(session.steps()) / static_cast<double>(wish.step);
        }
        if (session.steps() % kStepsSaid == 0) {
            published();
        }
    }
    return false;
}

void SessionPlayer::Run::take(const Take& wish)
{
    if (!journal->isWhole()) { // since a moment ago
        const std::scoped_lock lock(mutex);
        taking.reset();
        return;
    }
    journal->forgetFrom(wish.forgottenFrom);
    recorded.reset();
    steps = wish.step;
    std::unique_ptr<Session> again = isGivenUp(wish) ? nullptr : journal->begin();
    if (earlier) { // they are copied; whoever had them may be gone
        earlier = stepsBefore(cache, startSeconds - kTimeSlack);
    }
    auto kept =
        again ? std::make_unique<RecordedSession>(std::move(again), cacheAfterEarlier()) : nullptr;
    if (kept && replay(*kept, wish)) {
        goOnWith(std::move(kept));
        if (surfaceStep && *surfaceStep >= wish.forgottenFrom) {
            walkOn(std::exchange(surface, nullptr)); // what is known of the ground stays known
        }
    }
}

void SessionPlayer::Run::goOnWith(std::unique_ptr<RecordedSession> again)
{
    recorded = std::move(again);
    recorded->keep();
    auto next = std::make_shared<MotionReader>(recorded->motion());
    const double since = recorded->session().seconds() - startSeconds + kTimeSlack;
    const std::scoped_lock lock(mutex);
    cache = recorded->motion();
    reader = std::move(next);
    poses = {recorded->last()};
    std::erase_if(log, [since](const RuleFired& fired) { return fired.seconds > since; });
    taking.reset();
}

void SessionPlayer::Run::publish()
{
    const SessionPosePtr& pose = recorded->take();
    Session& session = recorded->session();
    std::vector<Problem> problems = session.problems();
    const std::vector<RuleFired> fired = session.rules().takeLog();
    const std::scoped_lock lock(mutex);
    if (poses.back()->step == pose->step) {
        poses.pop_back(); // the same step, after an edit
    }
    poses.push_back(pose);
    while (poses.size() > 1 && poses[1]->seconds <= poses.back()->seconds - kReadySeconds) {
        poses.pop_front();
    }
    report = {std::move(problems), session.rules().counts()};
    if (log.size() < kMaxLog) {
        log.insert(log.end(), fired.begin(), fired.end());
    }
}

/// Of those that need not be unpacked; under the mutex.
std::pair<SessionPosePtr, SessionPosePtr> SessionPlayer::Run::readyAround(double seconds,
                                                                          bool isLast) const
{
    const auto next = std::ranges::find_if(
        poses, [&](const SessionPosePtr& pose) { return pose->seconds > seconds; });
    const SessionPosePtr after = next == poses.end() ? poses.back() : *next;
    const SessionPosePtr before =
        next == poses.begin() || next == poses.end() ? after : *std::prev(next);
    return {before, isLast ? before : after};
}

} // namespace crowd::behavior
