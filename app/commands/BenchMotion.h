// SPDX-License-Identifier: MIT
#pragma once

namespace crowd::app {

/// crowdbrush bench motion: what it takes to keep a run, so that any moment of it is shown again.
struct BenchMotionOptions
{
    int count = 10000;
    int frames = 1000;
    bool json = false;
};

/// The exit code; prints the result, or one line on standard error. Needs no display.
[[nodiscard]] int runBenchMotion(const BenchMotionOptions& options);

} // namespace crowd::app
