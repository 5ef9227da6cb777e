// SPDX-License-Identifier: MIT
#pragma once

namespace crowd::app {

/// crowdbrush bench python: what a script costs against the same work in C++, in one process, one
/// after the other in turn. Medians.
struct BenchPythonOptions
{
    int count = 100'000; ///< people created from arrays and read back
    int rounds = 9;
    bool json = false;
};

/// The exit code; prints the result, or one line on standard error. Needs no display.
[[nodiscard]] int runBenchPython(const BenchPythonOptions& options);

} // namespace crowd::app
