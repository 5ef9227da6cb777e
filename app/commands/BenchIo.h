// SPDX-License-Identifier: MIT
#pragma once

namespace crowd::app {

/// crowdbrush bench io: saving and opening a project file, against what the JSON library alone
/// needs to write and to parse the same bytes, in turn in the same run; and reading the whole
/// built-in cast (BenchCast.h).
struct BenchIoOptions
{
    int count = 100000;
    int rounds = 5;
    bool json = false;
};

/// The exit code; prints the result, or one line on standard error. Needs no display.
[[nodiscard]] int runBenchIo(const BenchIoOptions& options);

} // namespace crowd::app
