// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <exception>
#include <optional>

#include <pybind11/pybind11.h>

#include "model/base/KeepGoing.h"

namespace crowd::app {

/// A call of a script's that takes long: lets Python's signals through, and tells the script how
/// far it is. What either raises ends the work; it is kept here until the work has taken itself
/// back. Under Python's lock, but in a hook's work.
class LongCall
{
public:
    using Listener = std::optional<pybind11::function>;
    explicit LongCall(Listener listener) : m_listener(std::move(listener)) {}

    /// From now on the work is this part of all of it: shares of 1.
    void within(double begin, double length)
    {
        m_begin = begin;
        m_length = length;
    }
    /// For as long as this lives.
    [[nodiscard]] model::KeepGoing hook()
    {
        return [this](double share) { return goesOn(share); };
    }
    /// Where something has ended the work, that.
    void raise() const;

private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] bool goesOn(double ofPart);

    double m_begin = 0.0;
    double m_length = 1.0;
    Listener m_listener; ///< of the share that is done
    Clock::time_point m_asked = Clock::now();
    Clock::time_point m_told = Clock::now();
    std::exception_ptr m_problem;
};

/// What all that takes `progress` says of it.
#define CROWD_PROGRESS_DOC                                                                         \
    "progress: is called with the share that is done, 0 to 1, some times a second; what it "       \
    "raises, "                                                                                     \
    "as Ctrl+C, ends the call, which takes back what it did."

} // namespace crowd::app
