// SPDX-License-Identifier: MIT
#include "app/python/OutsidePython.h"

#include <future>
#include <thread>
#include <utility>

#include <pthread.h>
#include <unistd.h>

namespace crowd::app {

namespace py = pybind11;

namespace {

constexpr std::chrono::milliseconds kMoment{50};
constexpr std::chrono::seconds kLongestStep{5}; ///< that Python's end waits for

std::atomic<int> workers{0}; ///< threads at work in our code
thread_local int depth = 0;  ///< how often this one came in without going out
std::atomic<bool> isPythonEnding{false};
std::atomic<std::thread::id> endingThread;

void comeIn()
{
    workers += depth++ == 0 ? 1 : 0;
}

void goOut()
{
    workers -= --depth == 0 ? 1 : 0;
}

/// Nobody waits for it any more.
[[noreturn]] void stayHere()
{
    workers -= depth > 0 ? 1 : 0;
    while (true) {
        pause();
    }
}

/// For threads that scripts left behind.
bool isOver()
{
    return isPythonEnding && endingThread.load() != std::this_thread::get_id();
}

/// A thread that Python ends is unwound from in there; it must not get past here.
void takeLock(PyThreadState* state)
{
    try {
        PyEval_RestoreThread(state);
    } catch (...) {
        stayHere();
    }
}

void beginEnd()
{
    endingThread = std::this_thread::get_id();
    isPythonEnding = true;
    PyThreadState* state = PyEval_SaveThread();
    const auto deadline = std::chrono::steady_clock::now() + kLongestStep;
    while (workers > 0 && std::chrono::steady_clock::now() < deadline) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    takeLock(state);
}

/// With Python's lock, which is let go.
void stayWhereOver()
{
    if (isOver()) {
        PyEval_SaveThread();
        stayHere();
    }
}

} // namespace

InsideModule::InsideModule()
{
    stayWhereOver();
    comeIn();
}

InsideModule::~InsideModule()
{
    goOut();
    stayWhereOver();
}

OutsidePython::OutsidePython()
{
    leave();
}

OutsidePython::~OutsidePython()
{
    comeBack();
}

void OutsidePython::leave()
{
    comeIn(); // under Python's lock: beginEnd() sees it
    m_state = PyEval_SaveThread();
    if (isOver()) {
        stayHere();
    }
}

void OutsidePython::comeBack()
{
    takeLock(m_state);
    goOut(); // Python's end waits until now
}

bool OutsidePython::isInterrupted()
{
    m_isInterrupted = m_isInterrupted || isOver();
    if (!m_isInterrupted && std::chrono::steady_clock::now() - m_asked >= kMoment) {
        takeLock(m_state);
        m_isInterrupted = PyErr_CheckSignals() != 0;
        m_state = PyEval_SaveThread();
        m_asked = std::chrono::steady_clock::now();
    }
    return m_isInterrupted;
}

bool OutsidePython::asked(const std::function<bool()>& question)
{
    takeLock(m_state);
    const bool answer = question();
    m_state = PyEval_SaveThread();
    return answer;
}

void raiseSignals()
{
    if (PyErr_CheckSignals() != 0) {
        throw py::error_already_set();
    }
}

py::object callPython(const py::object& callable, const py::tuple& arguments)
{
    PyObject* result = nullptr;
    const int inside = std::exchange(depth, 0);
    workers -= inside > 0 ? 1 : 0;
    try {
        result = PyObject_CallObject(callable.ptr(), arguments.ptr());
    } catch (...) {
        stayHere(); // C raises nothing: it is Python's way to end a thread
    }
    stayWhereOver();
    depth = inside;
    workers += inside > 0 ? 1 : 0;
    if (result == nullptr) {
        throw py::error_already_set();
    }
    return py::reinterpret_steal<py::object>(result);
}

void mindingSignals(std::atomic<bool>& isCancelled, const std::function<void()>& work,
                    const std::function<bool()>& goesOn)
{
    std::future<void> done;
    {
        OutsidePython others;
        done = std::async(std::launch::async, work);
        while (done.wait_for(kMoment) != std::future_status::ready) {
            if (others.isInterrupted() || (goesOn && !others.asked(goesOn))) {
                isCancelled = true;
                done.wait();
            }
        }
    }
    if (PyErr_Occurred() != nullptr) {
        throw py::error_already_set();
    }
    stayWhereOver();
    done.get();
}

void watchPythonsEnd()
{
    isPythonEnding = false;
    py::module_::import("atexit").attr("register")(py::cpp_function(&beginEnd));
    static const bool isWatchingForks = [] {
        // A child has but the thread that forked.
        return pthread_atfork(nullptr, nullptr, [] { workers = depth > 0 ? 1 : 0; }) == 0;
    }();
    (void)isWatchingForks;
}

} // namespace crowd::app
