// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

namespace crowd::app {

/// Says on standard error how far a picture is that takes long: now and then, in one line that
/// changes on a terminal, else in lines of their own.
class RenderProgress
{
public:
    RenderProgress();

    /// So many of the seconds that are wanted are simulated.
    void simulated(double done, double wanted);
    /// So much of a picture is drawn, 0 to 1.
    void drawn(double share);
    /// This one is over; other output may follow.
    void end();

private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] bool isTimeToSay();
    void say(const std::string& text);

    bool m_isTerminal;
    bool m_isLineOpen = false;
    Clock::time_point m_last;
};

} // namespace crowd::app
