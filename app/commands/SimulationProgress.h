// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace crowd::app {

/// Says on standard error how far a long simulation is: now and then, in one line that changes on a
/// terminal, else in lines of their own.
class SimulationProgress
{
public:
    SimulationProgress();

    /// So many of the seconds that are wanted are simulated.
    void tell(double done, double wanted);
    /// This one is over; other output may follow.
    void end();

private:
    using Clock = std::chrono::steady_clock;
    bool m_isTerminal;
    bool m_isLineOpen = false;
    Clock::time_point m_last;
};

} // namespace crowd::app
