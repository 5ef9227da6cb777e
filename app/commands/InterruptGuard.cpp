// SPDX-License-Identifier: MIT
#include "app/commands/InterruptGuard.h"

#include <atomic>
#include <csignal>

#include <unistd.h>

namespace crowd::app {

namespace {

constexpr int kSignalled = 128; ///< and the signal's number: what shells expect

// A handler of signals reaches nothing else.
std::atomic<bool> isGuarded{false};
std::atomic<int> heldSignal{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

extern "C" void endOrHold(int signal)
{
    if (!isGuarded) {
        ::_exit(kSignalled + signal);
    }
    heldSignal = signal;
}

} // namespace

InterruptGuard::InterruptGuard()
{
    isGuarded = true;
}

InterruptGuard::~InterruptGuard()
{
    isGuarded = false;
    if (const int signal = heldSignal; signal != 0) {
        ::_exit(kSignalled + signal);
    }
}

bool InterruptGuard::isToEnd()
{
    return heldSignal != 0;
}

void InterruptGuard::install()
{
    for (const int signal : {SIGINT, SIGTERM}) {
        if (std::signal(signal, endOrHold) == SIG_IGN) {
            std::signal(signal, SIG_IGN); // as whoever started the program wanted it
        }
    }
}

} // namespace crowd::app
