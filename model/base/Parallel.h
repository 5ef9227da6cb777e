// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace crowd::model {

/// Runs body(begin, end) over [0, count) in fixed chunks of `chunk` items, on all cores.
/// The chunks do not depend on the number of threads; each is run exactly once, in any order,
/// and all are finished on return. The only way this project loops in parallel: the thread
/// sanitizer build puts std::thread behind it instead of TBB. body must not throw.
void parallelFor(std::size_t count, std::size_t chunk,
                 const std::function<void(std::size_t begin, std::size_t end)>& body);

/// While it lives, parallelFor uses at most so many threads (at least 1): for measuring.
class ThreadLimit
{
public:
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    struct Limit;
    std::unique_ptr<Limit> m_limit;
};

} // namespace crowd::model
