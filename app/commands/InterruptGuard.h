// SPDX-License-Identifier: MIT
#pragma once

namespace crowd::app {

/// While one lives, Ctrl+C waits until it is gone; at other times it ends the program at once. So
/// what is written is whole, and nothing temporary stays behind. One at a time, on one thread.
class InterruptGuard
{
public:
    InterruptGuard();
    ~InterruptGuard(); ///< ends the program if it was to end meanwhile
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    /// Whether the program is to end as soon as the guard is gone.
    [[nodiscard]] static bool isToEnd();
    /// From now on; else Ctrl+C does what it always does.
    static void install();
};

} // namespace crowd::app
