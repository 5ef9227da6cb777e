// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

#include "model/base/Parallel.h"

namespace crowd::behavior {

/// Rows of a chunk, where there are several.
inline constexpr std::size_t kRowsAtOnce = 512;

/// Below so many rows, waking threads costs more than they save.
inline constexpr std::size_t kWorthThreads = 3000;

/// Runs body(begin, end) over all rows. In chunks on all cores when there are many.
inline void overRows(std::size_t rows, const std::function<void(std::size_t, std::size_t)>& body)
{
    if (rows < kWorthThreads) {
        body(0, rows);
    } else {
        model::parallelFor(rows, kRowsAtOnce, body);
    }
}

/// Runs body(item) over all items, each of which stands for about `rowsInEach` rows.
inline void overItems(std::size_t items, std::size_t rowsInEach,
                      const std::function<void(std::size_t)>& body)
{
    const auto all = [&body](std::size_t begin, std::size_t end) {
        for (std::size_t item = begin; item < end; ++item) {
            body(item);
        }
    };
    if (items * rowsInEach < kWorthThreads) {
        all(0, items);
    } else {
        model::parallelFor(items, std::max<std::size_t>(kRowsAtOnce / rowsInEach, 1), all);
    }
}

} // namespace crowd::behavior
