// SPDX-License-Identifier: MIT
#include "app/commands/RenderProgress.h"

#include <array>
#include <cstdio>

#include <unistd.h>

namespace crowd::app {

RenderProgress::RenderProgress() : m_isTerminal(::isatty(STDERR_FILENO) != 0), m_last(Clock::now())
{
}

bool RenderProgress::isTimeToSay()
{
    using namespace std::chrono_literals;
    const Clock::time_point now = Clock::now();
    if (now - m_last < (m_isTerminal ? 250ms : 2000ms)) {
        return false;
    }
    m_last = now;
    return true;
}

void RenderProgress::simulated(double done, double wanted)
{
    if (isTimeToSay()) {
        std::array<char, 80> text{};
        std::snprintf(text.data(), text.size(), "Simulated %.1f of %.1f s; Ctrl+C ends it.", done,
                      wanted);
        say(text.data());
    }
}

void RenderProgress::drawn(double share)
{
    if (isTimeToSay()) {
        std::array<char, 80> text{};
        std::snprintf(text.data(), text.size(), "Drawn %.0f %%; Ctrl+C ends it.", 100.0 * share);
        say(text.data());
    }
}

void RenderProgress::say(const std::string& text)
{
    std::fprintf(stderr, "%s%s%s", m_isTerminal ? "\r" : "", text.c_str(),
                 m_isTerminal ? "" : "\n");
    m_isLineOpen = m_isTerminal;
}

void RenderProgress::end()
{
    if (m_isLineOpen) {
        std::fputc('\n', stderr);
        m_isLineOpen = false;
    }
}

} // namespace crowd::app
