// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace crowd::app {

/// crowdbrush bench simulate: how many agent-steps a second, and whether they are right.
struct BenchSimulateOptions
{
    std::string workload = "square"; ///< "square", "corridor", "city" or "paths"
    int count = 10000;
    int steps = 300;
    int threads = 1;
    /// Every other block of steps on one thread, so that both are timed in the same minutes on the
    /// same crowd: the result says how much faster all threads are.
    bool againstOneThread = false;
    /// How much density slows walkers, 0 (free) to 1 (as observed); -1: the workload's own.
    double slowing = -1.0;
    bool validate = false; ///< the experiments of the field instead of a workload
    bool json = false;
};

/// The exit code; prints the result, or one line on standard error. Needs no display.
[[nodiscard]] int runBenchSimulate(const BenchSimulateOptions& options);

} // namespace crowd::app
