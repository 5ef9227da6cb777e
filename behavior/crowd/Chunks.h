// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

#include "model/base/Parallel.h"

namespace crowd::behavior {

/// Runs body(begin, end) over all rows. In chunks on all cores when there are many: below some
/// thousand rows, waking threads costs more than they save.
inline void overRows(std::size_t rows, const std::function<void(std::size_t, std::size_t)>& body)
{
    constexpr std::size_t kWorthThreads = 3000;
    constexpr std::size_t kChunk = 512;
    if (rows < kWorthThreads) {
        body(0, rows);
    } else {
        model::parallelFor(rows, kChunk, body);
    }
}

} // namespace crowd::behavior
