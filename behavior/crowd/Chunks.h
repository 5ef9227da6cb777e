// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

#include "model/base/Parallel.h"

namespace crowd::behavior {

/// Rows of a chunk, where there are several.
inline constexpr std::size_t kRowsAtOnce = 512;

/// Runs body(begin, end) over all rows. In chunks on all cores when there are many: below some
/// thousand rows, waking threads costs more than they save.
inline void overRows(std::size_t rows, const std::function<void(std::size_t, std::size_t)>& body)
{
    constexpr std::size_t kWorthThreads = 3000;
    if (rows < kWorthThreads) {
        body(0, rows);
    } else {
        model::parallelFor(rows, kRowsAtOnce, body);
    }
}

} // namespace crowd::behavior
