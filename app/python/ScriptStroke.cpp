// SPDX-License-Identifier: MIT
#include "app/python/ScriptStroke.h"

#include <chrono>

namespace crowd::app {

using namespace model;

namespace {

constexpr std::chrono::milliseconds kMoment{50};

} // namespace

ChangeResult ScriptStrokeLink::change(const ChangeRequest& request)
{
    m_edit = &request.edit;
    ChangeResult result;
    result.changed.assign(request.ids.begin(), request.ids.end());
    {
        const std::lock_guard lock(m_mutex);
        m_dabs.push_back({result.changed, request.seed, request.line, request.strokeHeading});
    }
    m_wake.notify_all();
    return result;
}

void ScriptStrokeLink::close()
{
    {
        const std::lock_guard lock(m_mutex);
        m_isClosed = true;
    }
    m_wake.notify_all();
}

void ScriptStrokeLink::abandon()
{
    m_edit = nullptr;
    {
        const std::lock_guard lock(m_mutex);
        m_dabs.clear();
    }
    close();
}

ScriptStrokeLink::Wait ScriptStrokeLink::next(ScriptDab& dab)
{
    std::unique_lock lock(m_mutex);
    m_wake.wait_for(lock, kMoment, [this] { return !m_dabs.empty() || m_isClosed; });
    if (m_dabs.empty()) {
        return m_isClosed ? Wait::End : Wait::Nothing;
    }
    dab = std::move(m_dabs.front());
    m_dabs.pop_front();
    ++m_taken;
    m_share = 0.0;
    return Wait::Dab;
}

void ScriptStrokeLink::report(double share)
{
    const std::lock_guard lock(m_mutex);
    m_share = share;
}

ScriptStrokeLink::Progress ScriptStrokeLink::progress() const
{
    const std::lock_guard lock(m_mutex);
    return {m_taken, static_cast<int>(m_dabs.size()), m_share};
}

} // namespace crowd::app
