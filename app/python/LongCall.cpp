// SPDX-License-Identifier: MIT
#include "app/python/LongCall.h"

#include <algorithm>

#include "app/python/OutsidePython.h"

namespace crowd::app {

namespace py = pybind11;

namespace {

constexpr std::chrono::milliseconds kBetweenSignals{50};
constexpr std::chrono::milliseconds kBetweenShares{250};

} // namespace

void LongCall::raise() const
{
    if (m_problem) {
        std::rethrow_exception(m_problem);
    }
}

bool LongCall::goesOn(double ofPart)
{
    const double share = m_begin + m_length * ofPart;
    const Clock::time_point now = Clock::now();
    const bool isDone = share >= 1.0 - 1e-9;
    if (m_problem || (!isDone && now - m_asked < kBetweenSignals)) {
        return !m_problem;
    }
    m_asked = now;
    try {
        raiseSignals();
        if (m_listener && (isDone || now - m_told >= kBetweenShares)) {
            m_told = now;
            (void)callPython(*m_listener, py::make_tuple(std::clamp(share, 0.0, 1.0)));
        }
    } catch (const py::error_already_set&) {
        m_problem = std::current_exception();
    }
    return !m_problem;
}

} // namespace crowd::app
