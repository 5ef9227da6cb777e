// SPDX-License-Identifier: MIT
#include "model/base/Parallel.h"

#include <algorithm>
#include <cassert>

#ifdef CROWD_PARALLEL_STD_THREADS
#include <atomic>
#include <thread>
#include <vector>
#else
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#endif

namespace crowd::model {

#ifdef CROWD_PARALLEL_STD_THREADS
namespace {
std::atomic<std::size_t> g_mostThreads{1024};
}

struct ThreadLimit::Limit
{
    explicit Limit(std::size_t threads) : before(g_mostThreads.exchange(threads)) {}
    ~Limit() { g_mostThreads = before; }
    Limit(const Limit&) = delete;
    Limit& operator=(const Limit&) = delete;
    std::size_t before;
};
#else
struct ThreadLimit::Limit
{
    explicit Limit(std::size_t threads)
        : control(oneapi::tbb::global_control::max_allowed_parallelism, threads)
    {
    }
    oneapi::tbb::global_control control;
};
#endif

ThreadLimit::ThreadLimit(int threads)
    : m_limit(std::make_unique<Limit>(static_cast<std::size_t>(std::max(threads, 1))))
{
}

ThreadLimit::~ThreadLimit() = default;

namespace {

void runChunk(std::size_t index, std::size_t count, std::size_t chunk,
              const std::function<void(std::size_t, std::size_t)>& body)
{
    const std::size_t begin = index * chunk;
    body(begin, std::min(begin + chunk, count));
}

#ifdef CROWD_PARALLEL_STD_THREADS
void runChunks(std::size_t chunks, const std::function<void(std::size_t)>& run)
{
    std::atomic<std::size_t> next{0};
    const std::size_t workers = std::min<std::size_t>(
        g_mostThreads, std::max<std::size_t>(2, std::thread::hardware_concurrency()));
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < std::min(workers, chunks); ++i) {
        threads.emplace_back([&] {
            for (std::size_t index = next++; index < chunks; index = next++) {
                run(index);
            }
        });
    }
}
#else
void runChunks(std::size_t chunks, const std::function<void(std::size_t)>& run)
{
    tbb::parallel_for(std::size_t{0}, chunks, run);
}
#endif

} // namespace

void parallelFor(std::size_t count, std::size_t chunk,
                 const std::function<void(std::size_t, std::size_t)>& body)
{
    assert(chunk > 0);
    const std::size_t chunks = (count + chunk - 1) / chunk;
    if (chunks <= 1) {
        if (count > 0) {
            body(0, count);
        }
        return;
    }
    runChunks(chunks, [&](std::size_t index) { runChunk(index, count, chunk, body); });
}

} // namespace crowd::model
