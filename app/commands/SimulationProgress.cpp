// SPDX-License-Identifier: MIT
#include "app/commands/SimulationProgress.h"

#include <cstdio>

#include <unistd.h>

namespace crowd::app {

SimulationProgress::SimulationProgress()
    : m_isTerminal(::isatty(STDERR_FILENO) != 0), m_last(Clock::now())
{
}

void SimulationProgress::tell(double done, double wanted)
{
    using namespace std::chrono_literals;
    const Clock::time_point now = Clock::now();
    if (now - m_last < (m_isTerminal ? 250ms : 2000ms)) {
        return;
    }
    m_last = now;
    std::fprintf(stderr, "%sSimulated %.1f of %.1f s; Ctrl+C ends it.%s", m_isTerminal ? "\r" : "",
                 done, wanted, m_isTerminal ? "" : "\n");
    m_isLineOpen = m_isTerminal;
}

void SimulationProgress::end()
{
    if (m_isLineOpen) {
        std::fputc('\n', stderr);
        m_isLineOpen = false;
    }
}

} // namespace crowd::app
