// SPDX-License-Identifier: MIT
#include "app/python/ScriptSession.h"

#include <algorithm>

#include "behavior/session/SceneMotion.h"

namespace crowd::app {

using namespace model;

namespace {

bool standsOnTheSame(const behavior::SurfacePlan& a, const behavior::SurfacePlan& b)
{
    const auto isSame = [](const StageEntry& one, const StageEntry& other) {
        return one.asset == other.asset && one.position == other.position &&
               one.headingRadians == other.headingRadians && one.scale == other.scale;
    };
    return std::ranges::equal(a.stages, b.stages, isSame) && a.hasSameWays(b);
}

} // namespace

ScriptSession::ScriptSession(std::shared_ptr<ScriptScene> scene) : m_scene(std::move(scene))
{
    follow();
}

ScriptSession::~ScriptSession() = default;

void ScriptSession::follow()
{
    const std::uint64_t revision = m_scene->revision();
    {
        const std::scoped_lock lock(m_mutex);
        if (m_session && revision == m_revision) {
            return;
        }
    }
    const auto now = m_scene->scene();
    const std::scoped_lock lock(m_mutex);
    m_revision = revision;
    if (!m_session) {
        m_session = std::make_unique<behavior::Session>(*now);
        m_stepsPerSecond = now->stepsPerSecond;
    } else {
        m_session->adopt(*now);
    }
    if (!now->hasBehaviour()) {
        return;
    }
    behavior::SurfacePlan plan = behavior::SurfacePlan::of(*now);
    if (!standsOnTheSame(plan, m_plan)) {
        m_surfaceProblem.clear();
        m_session->setSurface(behavior::surfaceOf(*now, m_surfaceProblem));
        m_plan = std::move(plan);
    }
}

void ScriptSession::step()
{
    const std::scoped_lock lock(m_mutex);
    m_session->step();
}

std::uint64_t ScriptSession::steps() const
{
    const std::scoped_lock lock(m_mutex);
    return m_session->steps();
}

double ScriptSession::seconds() const
{
    const std::scoped_lock lock(m_mutex);
    return m_session->seconds();
}

CrowdFramePtr ScriptSession::frame() const
{
    const std::scoped_lock lock(m_mutex);
    return m_session->frame();
}

void ScriptSession::send(const std::string& event, float number,
                         const std::vector<IndividualId>& ids)
{
    const std::scoped_lock lock(m_mutex);
    m_session->send(event, number, ids);
}

void ScriptSession::sendTagged(const std::string& event, float number, std::uint8_t tag)
{
    const std::scoped_lock lock(m_mutex);
    m_session->sendTagged(event, number, tag);
}

std::map<RuleId, std::uint64_t> ScriptSession::fired() const
{
    const std::scoped_lock lock(m_mutex);
    return m_session->rules().counts();
}

std::vector<behavior::RuleFired> ScriptSession::takeLog()
{
    const std::scoped_lock lock(m_mutex);
    return m_session->rules().takeLog();
}

std::vector<std::string> ScriptSession::problems() const
{
    const std::scoped_lock lock(m_mutex);
    std::vector<std::string> problems;
    for (const behavior::Problem& problem : m_session->problems()) {
        problems.push_back(problem.text);
    }
    if (!m_surfaceProblem.empty()) {
        problems.push_back(m_surfaceProblem);
    }
    return problems;
}

Result<int> ScriptSession::keepPose()
{
    follow();
    CrowdFramePtr shown;
    behavior::SessionPosePtr pose;
    {
        const std::scoped_lock lock(m_mutex); // both of the same step
        shown = m_session->frame();
        pose = m_session->pose();
    }
    auto kept = m_scene->keepPose(shown->population, *pose);
    if (kept) {
        // Where people are in the scene is where they are here.
        const auto now = m_scene->scene();
        const std::scoped_lock lock(m_mutex);
        m_revision = m_scene->revision();
        m_session->adopt(*now, true);
    }
    return kept;
}

} // namespace crowd::app
