// SPDX-License-Identifier: MIT
#include "widgets/state/SurfaceBuilder.h"

#include <atomic>
#include <thread>
#include <utility>

namespace crowd::widgets {

struct SurfaceBuilder::Job
{
    behavior::WalkSurface::Progress progress;
    std::optional<model::Result<SurfacePtr>> result; ///< of the thread, once it is done
    std::atomic<bool> isDone{false};                 ///< nothing is worked on any more
    std::vector<std::unique_ptr<Job>> before;        ///< cancelled ones: never two at work
    std::jthread thread;                             ///< last: ends first

    void build(const behavior::SurfacePlan& plan)
    {
        before.clear();
        auto built = behavior::WalkSurface::build(plan, progress);
        if (!progress.isCancelled) {
            result.emplace(std::move(built));
        }
        isDone = true;
    }
};

SurfaceBuilder::SurfaceBuilder() = default;

SurfaceBuilder::~SurfaceBuilder()
{
    cancel();
}

void SurfaceBuilder::start(behavior::SurfacePlan plan, std::function<void()> done)
{
    cancel();
    m_job = std::make_unique<Job>();
    m_job->before = std::exchange(m_cancelled, {});
    m_job->thread =
        std::jthread([job = m_job.get(), plan = std::move(plan), done = std::move(done)]() mutable {
            job->build(plan);
            plan = {}; // the stages in it may be waited for
            if (done) {
                done();
            }
        });
}

void SurfaceBuilder::cancel()
{
    if (m_job) {
        m_job->progress.isCancelled = true;
        m_cancelled.push_back(std::move(m_job));
    }
    std::erase_if(m_cancelled, [](const auto& job) { return job->isDone.load(); });
}

float SurfaceBuilder::progress() const
{
    return m_job ? m_job->progress.done.load() : 0.0F;
}

void SurfaceBuilder::wait()
{
    if (m_job && m_job->thread.joinable()) {
        m_job->thread.join();
    }
}

std::optional<model::Result<SurfacePtr>> SurfaceBuilder::take()
{
    if (!m_job || !m_job->isDone) {
        return std::nullopt;
    }
    wait();
    return std::move(std::exchange(m_job, nullptr)->result);
}

} // namespace crowd::widgets
