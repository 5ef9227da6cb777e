// SPDX-License-Identifier: MIT
#include "model/bake/KeyframeStore.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "model/bake/ClipBaker.h"
#include "model/bake/SharedClips.h"

namespace crowd::model {

namespace {

using ClipKey = std::pair<const Template*, int>;

/// A clip that was asked for. `owner` tells a template from a later one at the same address.
struct Kept
{
    std::weak_ptr<const Template> owner;
    BakedClipPtr clip; ///< the first keyframe until isComplete
    bool isComplete = false;
    bool isScheduled = false;
    std::size_t fullBytes = 0;     ///< what the complete clip takes
    std::size_t reservedBytes = 0; ///< counted against the budget
};

/// Holds the template while it waits and is baked, and not a moment longer: whoever waited for it
/// may let go of the template and count on its space.
struct Job
{
    TemplatePtr asset;
    int clipIndex = 0;
};

int workerCount()
{
    return std::clamp(static_cast<int>(std::thread::hardware_concurrency()) - 1, 1, 2);
}

} // namespace

struct KeyframeStore::Private
{
    explicit Private(std::size_t budget) : budgetBytes(budget) {}

    mutable std::mutex mutex;
    std::condition_variable_any jobAdded;
    std::condition_variable jobDone;
    std::map<ClipKey, Kept> kept;
    std::deque<Job> queue;
    int running = 0;
    int finished = 0;
    std::size_t reservedBytes = 0;
    std::size_t budgetBytes;
    bool isBudgetReached = false;
    std::atomic<std::uint64_t> version{0};
    std::atomic<bool> isStopping{false};
    std::atomic<bool> isPaused{false};
    std::mutex callbackMutex; ///< held while the callback runs
    std::function<void()> callback;
    std::vector<std::jthread> workers; ///< last: ends first

    void forgetExpired();
    Kept addFirstKeyframe(const TemplatePtr& asset, int clipIndex);
    void schedule(const TemplatePtr& asset, int clipIndex, Kept& entry);
    void unschedule(const Job& job);
    bool runOne(std::unique_lock<std::mutex>& lock);
    void work(const std::stop_token& stop);
};

void KeyframeStore::Private::forgetExpired()
{
    std::erase_if(kept, [this](const auto& item) {
        if (!item.second.owner.expired()) {
            return false;
        }
        reservedBytes -= item.second.reservedBytes;
        isBudgetReached = false;
        return true;
    });
}

/// A clip that needs no more than its first keyframe is complete with it, and so is one that
/// somebody else has baked: that takes no more memory.
Kept KeyframeStore::Private::addFirstKeyframe(const TemplatePtr& asset, int clipIndex)
{
    if (BakedClipPtr shared = findSharedClip(asset, clipIndex)) {
        const std::size_t bytes = shared->bytes();
        reservedBytes += bytes;
        return {asset, std::move(shared), true, false, bytes, bytes};
    }
    Kept entry{asset, bakeClip(*asset, clipIndex, 1)};
    entry.fullBytes = bakedBytes(*asset, clipIndex);
    entry.reservedBytes = entry.clip->bytes();
    const Clip& clip = asset->clips[static_cast<std::size_t>(clipIndex)];
    entry.isComplete = clip.keyframeCount() == 1;
    reservedBytes += entry.reservedBytes;
    return entry;
}

/// Space is set aside when a clip is asked for, so that what fits depends on the order of asking
/// and not on the speed of the workers. What did not fit is tried again when it is asked for again.
void KeyframeStore::Private::schedule(const TemplatePtr& asset, int clipIndex, Kept& entry)
{
    if (reservedBytes - entry.reservedBytes + entry.fullBytes > budgetBytes) {
        isBudgetReached = true;
        return;
    }
    reservedBytes += entry.fullBytes - entry.reservedBytes;
    entry.reservedBytes = entry.fullBytes;
    entry.isScheduled = true;
    queue.push_back({asset, clipIndex});
    jobAdded.notify_one();
}

/// Back to the first keyframe alone, until it is asked for again.
void KeyframeStore::Private::unschedule(const Job& job)
{
    const auto found = kept.find({job.asset.get(), job.clipIndex});
    if (found == kept.end() || found->second.isComplete) {
        return;
    }
    Kept& entry = found->second;
    reservedBytes -= entry.reservedBytes - entry.clip->bytes();
    entry.reservedBytes = entry.clip->bytes();
    entry.isScheduled = false;
}

/// Takes a job, if there is one, and bakes it without the lock.
bool KeyframeStore::Private::runOne(std::unique_lock<std::mutex>& lock)
{
    if (queue.empty()) {
        return false;
    }
    Job job = std::move(queue.front());
    queue.pop_front();
    ++running;
    lock.unlock();
    const Clip& clip = job.asset->clips[static_cast<std::size_t>(job.clipIndex)];
    BakedClipPtr baked = findSharedClip(job.asset, job.clipIndex);
    if (!baked) {
        baked = bakeClip(*job.asset, job.clipIndex, clip.keyframeCount(),
                         [this] { return isStopping.load() || isPaused.load(); });
        if (baked) {
            shareClip(job.asset, job.clipIndex, baked);
        }
    }
    lock.lock();
    --running;
    const auto found = kept.find({job.asset.get(), job.clipIndex});
    if (baked && found != kept.end()) {
        found->second.clip = std::move(baked);
        found->second.isComplete = true;
        ++finished;
        ++version;
    } else if (!baked) {
        unschedule(job);
    }
    job.asset.reset();
    jobDone.notify_all();
    lock.unlock();
    {
        const std::lock_guard<std::mutex> guard(callbackMutex);
        if (callback && !isStopping) {
            callback();
        }
    }
    lock.lock();
    return true;
}

void KeyframeStore::Private::work(const std::stop_token& stop)
{
    std::unique_lock<std::mutex> lock(mutex);
    while (jobAdded.wait(lock, stop, [this] { return !queue.empty(); })) {
        if (stop.stop_requested()) {
            return;
        }
        runOne(lock);
    }
}

KeyframeStore::KeyframeStore(std::size_t budgetBytes)
    : m_private(std::make_unique<Private>(budgetBytes))
{
    for (int i = 0; i < workerCount(); ++i) {
        m_private->workers.emplace_back(
            [data = m_private.get()](const std::stop_token& stop) { data->work(stop); });
    }
}

KeyframeStore::~KeyframeStore()
{
    m_private->isStopping = true;
    for (std::jthread& worker : m_private->workers) {
        worker.request_stop();
    }
    m_private->workers.clear();
}

KeyframeStore::Entry KeyframeStore::clip(const TemplatePtr& asset, int clipIndex)
{
    const std::lock_guard<std::mutex> guard(m_private->mutex);
    const ClipKey key{asset.get(), clipIndex};
    auto found = m_private->kept.find(key);
    if (found != m_private->kept.end() && found->second.owner.expired()) {
        m_private->forgetExpired();
        found = m_private->kept.end();
    }
    if (found == m_private->kept.end()) {
        m_private->forgetExpired();
        found = m_private->kept.emplace(key, m_private->addFirstKeyframe(asset, clipIndex)).first;
    }
    if (Kept& entry = found->second;
        !entry.isComplete && !entry.isScheduled && !m_private->isPaused) {
        m_private->forgetExpired();
        m_private->schedule(asset, clipIndex, entry);
    }
    return {found->second.clip, found->second.isComplete};
}

void KeyframeStore::waitForAll()
{
    std::unique_lock<std::mutex> lock(m_private->mutex);
    while (m_private->runOne(lock)) {
    }
    m_private->jobDone.wait(lock,
                            [this] { return m_private->queue.empty() && m_private->running == 0; });
}

void KeyframeStore::clear()
{
    std::unique_lock<std::mutex> lock(m_private->mutex);
    m_private->queue.clear();
    m_private->jobDone.wait(lock, [this] { return m_private->running == 0; });
    m_private->kept.clear();
    m_private->reservedBytes = 0;
    m_private->isBudgetReached = false;
    m_private->jobDone.notify_all();
}

void KeyframeStore::releaseUnused()
{
    const std::lock_guard<std::mutex> guard(m_private->mutex);
    m_private->forgetExpired();
}

KeyframeStore::Progress KeyframeStore::progress() const
{
    const std::lock_guard<std::mutex> guard(m_private->mutex);
    return {static_cast<int>(m_private->queue.size()) + m_private->running,
            m_private->finished,
            m_private->reservedBytes,
            m_private->budgetBytes,
            m_private->isBudgetReached,
            m_private->isPaused};
}

void KeyframeStore::setBudget(std::size_t bytes)
{
    const std::lock_guard<std::mutex> guard(m_private->mutex);
    m_private->budgetBytes = bytes;
    m_private->isBudgetReached = false;
}

void KeyframeStore::setPaused(bool isPaused)
{
    const std::lock_guard<std::mutex> guard(m_private->mutex);
    m_private->isPaused = isPaused;
    if (isPaused) {
        for (const Job& job : m_private->queue) {
            m_private->unschedule(job);
        }
        m_private->queue.clear();
        m_private->jobDone.notify_all();
    }
}

void KeyframeStore::setFinishedCallback(std::function<void()> callback)
{
    const std::lock_guard<std::mutex> guard(m_private->callbackMutex);
    m_private->callback = std::move(callback);
}

std::uint64_t KeyframeStore::version() const
{
    return m_private->version;
}

} // namespace crowd::model
