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
#include "model/bake/Impostor.h"
#include "model/bake/SharedClips.h"

namespace crowd::model {

namespace {

constexpr int kKeyframes = -1; ///< instead of a band of impostors

struct BakedKey
{
    const Template* asset;
    int clipIndex;
    int band; ///< or kKeyframes

    // NOLINTNEXTLINE(modernize-use-nullptr): the checker means the compared zero
    friend auto operator<=>(const BakedKey&, const BakedKey&) = default;
};

/// What was asked for: a clip, or its impostors in a band. `owner` tells a template from a later
/// one at the same address.
struct Kept
{
    std::weak_ptr<const Template> owner;
    BakedClipPtr clip;                  ///< the first keyframe until isComplete; null of impostors
    ImpostorSetPtr impostors = nullptr; ///< null until isComplete
    bool isComplete = false;
    bool isScheduled = false;
    std::size_t fullBytes = 0;     ///< what it takes when complete
    std::size_t reservedBytes = 0; ///< counted against the budget

    /// Of what stands in until it is complete.
    [[nodiscard]] std::size_t standInBytes() const { return clip ? clip->bytes() : 0; }
};

/// Holds the template while it waits and is baked, and not a moment longer: whoever waited for it
/// may let go of the template and count on its space.
struct Job
{
    TemplatePtr asset;
    int clipIndex = 0;
    int band = kKeyframes;
    BakedClipPtr of{}; ///< complete, that impostors are made of

    [[nodiscard]] BakedKey key() const { return {asset.get(), clipIndex, band}; }
};

/// What a job makes: neither of them when it was given up.
struct Made
{
    BakedClipPtr clip;
    ImpostorSetPtr impostors;
};

Made bake(const Job& job, const std::function<bool()>& isCancelled)
{
    if (job.band != kKeyframes) {
        return {nullptr, bakeImpostors(*job.asset, job.clipIndex, *job.of, job.band, isCancelled)};
    }
    BakedClipPtr clip = findSharedClip(job.asset, job.clipIndex);
    if (!clip) {
        const Clip& wanted = job.asset->clips[static_cast<std::size_t>(job.clipIndex)];
        clip = bakeClip(*job.asset, job.clipIndex, wanted.keyframeCount(), isCancelled);
        if (clip) {
            shareClip(job.asset, job.clipIndex, clip);
        }
    }
    return {std::move(clip), nullptr};
}

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
    std::map<BakedKey, Kept> kept;
    std::deque<Job> queue;
    int running = 0;
    int runningClips = 0;
    int finished = 0; ///< clips
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
    void forgetImpostors();
    Kept* find(const BakedKey& key);
    Kept addFirstKeyframe(const TemplatePtr& asset, int clipIndex);
    void ask(Job job, Kept& entry);
    void schedule(Job job, Kept& entry);
    void finish(const Job& job, Made made);
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

/// They make room for what cannot be done without; who has drawn them has them on the card.
void KeyframeStore::Private::forgetImpostors()
{
    std::erase_if(kept, [this](const auto& item) {
        const bool isForgotten = item.first.band != kKeyframes && item.second.isComplete;
        reservedBytes -= isForgotten ? item.second.reservedBytes : 0;
        return isForgotten;
    });
}

/// Null where it was not asked for, or of another template at the same address.
Kept* KeyframeStore::Private::find(const BakedKey& key)
{
    const auto found = kept.find(key);
    if (found != kept.end() && found->second.owner.expired()) {
        forgetExpired();
        return nullptr;
    }
    return found != kept.end() ? &found->second : nullptr;
}

/// Unless it is there or on its way.
void KeyframeStore::Private::ask(Job job, Kept& entry)
{
    if (!entry.isComplete && !entry.isScheduled && !isPaused) {
        forgetExpired();
        schedule(std::move(job), entry);
    }
}

/// A clip that needs no more than its first keyframe is complete with it, and so is one that
/// somebody else has baked: that takes no more memory.
Kept KeyframeStore::Private::addFirstKeyframe(const TemplatePtr& asset, int clipIndex)
{
    if (BakedClipPtr shared = findSharedClip(asset, clipIndex)) {
        const std::size_t bytes = shared->bytes();
        reservedBytes += bytes;
        return {asset, std::move(shared), nullptr, true, false, bytes, bytes};
    }
    Kept entry{asset, bakeClip(*asset, clipIndex, 1), nullptr};
    entry.fullBytes = bakedBytes(*asset, clipIndex);
    entry.reservedBytes = entry.clip->bytes();
    const Clip& clip = asset->clips[static_cast<std::size_t>(clipIndex)];
    entry.isComplete = clip.keyframeCount() == 1;
    reservedBytes += entry.reservedBytes;
    return entry;
}

/// Space is set aside when a clip is asked for, so that what fits depends on the order of asking
/// and not on the speed of the workers. What did not fit is tried again when it is asked for again.
void KeyframeStore::Private::schedule(Job job, Kept& entry)
{
    const auto isTooMuch = [&] {
        return reservedBytes - entry.reservedBytes + entry.fullBytes > budgetBytes;
    };
    if (isTooMuch() && job.band == kKeyframes) {
        forgetImpostors();
    }
    if (isTooMuch()) {
        isBudgetReached = isBudgetReached || job.band == kKeyframes; // else triangles are drawn
        return;
    }
    reservedBytes += entry.fullBytes - entry.reservedBytes;
    entry.reservedBytes = entry.fullBytes;
    entry.isScheduled = true;
    queue.push_back(std::move(job));
    jobAdded.notify_one();
}

/// Back to the first keyframe alone, until it is asked for again.
void KeyframeStore::Private::unschedule(const Job& job)
{
    const auto found = kept.find(job.key());
    if (found == kept.end() || found->second.isComplete) {
        return;
    }
    Kept& entry = found->second;
    reservedBytes -= entry.reservedBytes - entry.standInBytes();
    entry.reservedBytes = entry.standInBytes();
    entry.isScheduled = false;
}

void KeyframeStore::Private::finish(const Job& job, Made made)
{
    const auto found = kept.find(job.key());
    if (!made.clip && !made.impostors) {
        unschedule(job);
    } else if (found != kept.end()) {
        Kept& entry = found->second;
        entry.clip = std::move(made.clip);
        entry.impostors = std::move(made.impostors);
        if (entry.impostors) { // less than whole cards, for which room was kept
            reservedBytes -= entry.reservedBytes - entry.impostors->bytes();
            entry.reservedBytes = entry.impostors->bytes();
        }
        entry.isComplete = true;
        finished += entry.clip ? 1 : 0;
        ++version;
    }
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
    const int clips = job.band == kKeyframes ? 1 : 0;
    runningClips += clips;
    lock.unlock();
    Made made = bake(job, [this] { return isStopping.load() || isPaused.load(); });
    lock.lock();
    --running;
    runningClips -= clips;
    finish(job, std::move(made));
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
    const BakedKey key{asset.get(), clipIndex, kKeyframes};
    Kept* entry = m_private->find(key);
    if (entry == nullptr) {
        m_private->forgetExpired();
        entry = &m_private->kept.emplace(key, m_private->addFirstKeyframe(asset, clipIndex))
                     .first->second;
    }
    m_private->ask({asset, clipIndex}, *entry);
    return {entry->clip, entry->isComplete};
}

ImpostorSetPtr KeyframeStore::impostors(const TemplatePtr& asset, int clipIndex,
                                        const BakedClipPtr& clip, int band)
{
    const std::lock_guard<std::mutex> guard(m_private->mutex);
    const BakedKey key{asset.get(), clipIndex, band};
    Kept* entry = m_private->find(key);
    if (entry == nullptr) {
        m_private->forgetExpired();
        Kept fresh{asset, nullptr, nullptr};
        fresh.fullBytes = impostorLayout(*asset, clipIndex, *clip, band).mostBytes();
        entry = &m_private->kept.emplace(key, std::move(fresh)).first->second;
    }
    m_private->ask({asset, clipIndex, band, clip}, *entry);
    return entry->impostors;
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
    // Nobody waits for impostors: triangles stand in.
    const auto waiting = std::ranges::count(m_private->queue, kKeyframes, &Job::band);
    return {static_cast<int>(waiting) + m_private->runningClips,
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
