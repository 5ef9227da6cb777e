// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <functional>

#include <pybind11/pybind11.h>

namespace crowd::app {

/// While one lives a thread is in a function of ours, wherever Python's lock is. Begins and ends
/// with that lock. Python's end waits for those who are in there, and lets nobody in or out any
/// more: it would unwind their stacks, and let objects go without its lock.
class InsideModule
{
public:
    InsideModule();
    ~InsideModule();
    InsideModule(const InsideModule&) = delete;
    InsideModule& operator=(const InsideModule&) = delete;
};

/// While it lives Python's other threads run. Begins and ends on a thread that has Python's lock,
/// with none of our own locks held: whoever waits for one of those may have Python's.
///
/// When Python ends, threads that scripts left behind stay where they are: Python would end them
/// by unwinding their stacks, which ends the program where code of ours is on them.
class OutsidePython
{
public:
    OutsidePython();
    ~OutsidePython();
    OutsidePython(const OutsidePython&) = delete;
    OutsidePython& operator=(const OutsidePython&) = delete;

    /// Lets Python handle its signals where a moment has passed since it did. True: one raised, an
    /// exception waits in Python, and what is being done is to end; also as Python ends.
    [[nodiscard]] bool isInterrupted();
    /// The answer, with Python's lock.
    [[nodiscard]] bool asked(const std::function<bool()>& question);

private:
    void leave();
    void comeBack();

    PyThreadState* m_state = nullptr;
    std::chrono::steady_clock::time_point m_asked = std::chrono::steady_clock::now();
    bool m_isInterrupted = false;
};

/// The result of work that needs no Python and holds no lock when it is done.
template<class Work>
auto outsidePython(const Work& work)
{
    const OutsidePython others;
    return work();
}

/// Raises what Python's signals raise, KeyboardInterrupt for one.
void raiseSignals();

/// Calls what is written in Python, from a function of ours. A thread that Python ends in there
/// stays where it is, as those that are inside the module.
[[nodiscard]] pybind11::object callPython(const pybind11::object& callable,
                                          const pybind11::tuple& arguments = pybind11::tuple());

/// Does work that takes long and needs no Python on another thread, while this one minds Python's
/// signals. Where one raises, isCancelled becomes true, and its exception comes out of here when
/// the work has ended. What the work throws comes out as well.
/// `goesOn`: asked now and then, with Python's lock; false cancels as well, and nothing comes out.
void mindingSignals(std::atomic<bool>& isCancelled, const std::function<void()>& work,
                    const std::function<bool()>& goesOn = {});

/// Python's end waits for those who are inside, or outside Python. Once for a module.
void watchPythonsEnd();

} // namespace crowd::app
