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

ScriptSession::ScriptSession(std::shared_ptr<ScriptScene> scene, bool isRecorded,
                             std::optional<behavior::RunBeginning> beginning)
    : m_scene(std::move(scene)), m_beginning(std::move(beginning)),
      m_motion(isRecorded ? std::make_shared<behavior::MotionCache>() : nullptr)
{
}

ScriptSession::~ScriptSession() = default;

bool ScriptSession::isUpToDate(std::uint64_t revision) const
{
    const std::scoped_lock lock(m_mutex);
    return m_isComplete && revision <= m_revision;
}

void ScriptSession::begin(const Scene& scene)
{
    m_run = std::make_unique<behavior::RecordedSession>(std::make_unique<behavior::Session>(scene),
                                                        m_motion);
    m_stepsPerSecond = scene.stepsPerSecond;
}

/// Of a take, whose steps until then are kept with those that follow.
void ScriptSession::beginFrom(const behavior::RunBeginning& beginning)
{
    session().beginFrom(*beginning.before, *beginning.now);
    if (m_motion) {
        beginning.earlier([this](const behavior::SessionPosePtr& pose) {
            m_motion->add(pose);
            return true;
        });
    }
}

void ScriptSession::follow(const ScriptScene::Snapshot& now, const std::atomic<bool>& isCancelled)
{
    const Scene& scene = *now.scene;
    const std::scoped_lock lock(m_mutex);
    if (m_isComplete && now.revision <= m_revision) {
        return;
    }
    m_isComplete = false;
    if (!m_run) {
        begin(scene);
    } else if (now.change && now.changeRevision >= m_revision) {
        session().adopt(scene, *now.change);
    } else {
        session().adopt(scene);
    }
    if (scene.hasBehaviour()) {
        behavior::SurfacePlan plan = behavior::SurfacePlan::of(scene);
        if (!standsOnTheSame(plan, m_plan)) {
            m_surfaceProblem = {};
            auto surface = behavior::surfaceOf(scene, m_surfaceProblem, &isCancelled);
            if (isCancelled) {
                return;
            }
            session().setSurface(std::move(surface));
            m_plan = std::move(plan);
        }
    }
    if (m_beginning) {
        beginFrom(*m_beginning);
        m_beginning.reset();
    }
    m_revision = now.revision;
    m_isComplete = true;
}

void ScriptSession::step()
{
    const std::scoped_lock lock(m_mutex);
    if (m_motion && session().steps() == 0) {
        m_run->take(); // as it has begun
    }
    m_run->step();
    if (m_motion) {
        m_run->take();
        m_run->keep();
    }
}

std::uint64_t ScriptSession::steps() const
{
    const std::scoped_lock lock(m_mutex);
    return session().steps();
}

double ScriptSession::seconds() const
{
    const std::scoped_lock lock(m_mutex);
    return session().seconds();
}

CrowdFramePtr ScriptSession::frame() const
{
    const std::scoped_lock lock(m_mutex);
    return session().frame();
}

CrowdFramePtr ScriptSession::frameBefore() const
{
    const std::scoped_lock lock(m_mutex);
    const behavior::SessionPosePtr& before = m_run->before();
    if (!before) {
        return nullptr;
    }
    auto frame = std::make_shared<CrowdFrame>(*session().frame());
    frame->seconds = before->seconds;
    behavior::applyPose(*before, *before, *frame);
    return frame;
}

std::vector<std::uint8_t> ScriptSession::present() const
{
    const Pose now = pose();
    std::vector<std::uint8_t> present(now.shown->population.size(), 1);
    for (std::size_t i = 0; i < now.pose->ids.size(); ++i) {
        if ((now.pose->flags[i] & behavior::kPoseGone) != 0) {
            present[now.shown->population.rowOf(now.pose->ids[i])] = 0;
        }
    }
    return present;
}

std::vector<PathId> ScriptSession::paths() const
{
    const std::scoped_lock lock(m_mutex);
    return session().paths();
}

StateRecall ScriptSession::recall(const ChangeOver& change)
{
    const std::scoped_lock lock(m_mutex);
    return session().recall(change);
}

void ScriptSession::send(const std::string& event, float number,
                         const std::vector<IndividualId>& ids)
{
    const std::scoped_lock lock(m_mutex);
    session().send(event, number, ids);
}

void ScriptSession::sendTagged(const std::string& event, float number, std::uint8_t tag)
{
    const std::scoped_lock lock(m_mutex);
    session().sendTagged(event, number, tag);
}

std::map<RuleId, std::uint64_t> ScriptSession::fired() const
{
    const std::scoped_lock lock(m_mutex);
    return session().rules().counts();
}

std::vector<behavior::RuleFired> ScriptSession::takeLog()
{
    const std::scoped_lock lock(m_mutex);
    return session().rules().takeLog();
}

std::vector<std::string> ScriptSession::problems() const
{
    const std::scoped_lock lock(m_mutex);
    std::vector<std::string> problems;
    for (const behavior::Problem& problem : session().problems()) {
        problems.push_back(problem.text.english());
    }
    if (!m_surfaceProblem.empty()) {
        problems.push_back(m_surfaceProblem.english());
    }
    return problems;
}

std::shared_ptr<behavior::MotionCache> ScriptSession::motion()
{
    const std::scoped_lock lock(m_mutex);
    if (m_motion) {
        m_run->take();
    }
    return m_run->wholeMotion();
}

ScriptSession::Pose ScriptSession::pose() const
{
    const std::scoped_lock lock(m_mutex); // both of the same step
    return {session().frame(), session().pose()};
}

void ScriptSession::adoptKept(const ScriptScene::Snapshot& kept)
{
    const std::scoped_lock lock(m_mutex);
    if (kept.revision > m_revision) {
        m_revision = kept.revision;
        session().adopt(*kept.scene, true);
    }
}

} // namespace crowd::app
