// SPDX-License-Identifier: MIT
#pragma once

namespace crowd::app {

/// crowdbrush bench paint: how long a brush takes among many people.
struct BenchPaintOptions
{
    int count = 10000;
    bool json = false;
};

/// The exit code; prints the result, or one line on standard error. Needs no display.
[[nodiscard]] int runBenchPaint(const BenchPaintOptions& options);

} // namespace crowd::app
