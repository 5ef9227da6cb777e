// SPDX-License-Identifier: MIT
#include "behavior/session/SceneMotion.h"

#include "behavior/surface/WalkSurface.h"
#include "behavior/takes/EditedTake.h"

namespace crowd::behavior {

namespace {

constexpr double kSlack = 1e-9; ///< seconds

} // namespace

std::shared_ptr<const WalkSurface> surfaceOf(const model::Scene& scene, model::Message& problem,
                                             const std::atomic<bool>* isCancelled)
{
    const SurfacePlan plan = SurfacePlan::of(scene);
    if (!plan.isWorthwhile()) {
        return nullptr;
    }
    WalkSurface::Progress progress;
    progress.isCancelledToo = isCancelled;
    auto built = WalkSurface::build(plan, progress);
    if (!built) {
        problem = built.error().said;
        return nullptr;
    }
    return built.value();
}

SceneMotion::SceneMotion(const model::Scene& scene, const std::atomic<bool>* isCancelled)
    : m_scene(scene),
      m_templates(std::make_shared<const std::vector<model::TemplateEntry>>(scene.templates))
{
    if (openShownTake() || !scene.hasBehaviour()) {
        return;
    }
    m_surface = surfaceOf(scene, m_surfaceProblem, isCancelled);
    begin();
}

SceneMotion::~SceneMotion() = default;

/// False: there is none, or it cannot be had: then it is as if it were not shown.
bool SceneMotion::openShownTake()
{
    const model::Take* shown = model::shownTake(m_scene.takes);
    if (shown == nullptr) {
        return false;
    }
    auto opened = EditedTake::open(*shown, m_scene);
    if (!opened) {
        m_takeProblem = opened.error().said;
        return false;
    }
    m_take = std::move(opened).value();
    return true;
}

void SceneMotion::begin()
{
    auto session = std::make_unique<Session>(m_scene);
    if (m_surface) {
        session->setSurface(m_surface);
    }
    MotionBudget budget; // pictures are asked for forwards, mostly
    budget.diskBytes = 0;
    m_run = std::make_unique<RecordedSession>(std::move(session),
                                              std::make_shared<MotionCache>(budget));
    m_run->take();
}

/// Steps of the run; null: cancelled.
std::pair<SessionPosePtr, SessionPosePtr>
SceneMotion::around(double seconds, const std::atomic<bool>* isCancelled, const Progress& notify)
{
    if (auto known = m_run->around(seconds); known.first && seconds < m_run->last()->seconds) {
        return known;
    }
    if (seconds < m_run->last()->seconds) {
        begin(); // all that was kept has no room
    }
    while (m_run->last()->seconds < seconds - kSlack) {
        if (isCancelled != nullptr && *isCancelled) {
            return {};
        }
        m_run->advance();
        if (notify) {
            notify(m_run->last()->seconds);
        }
    }
    return m_run->around(seconds);
}

model::CrowdFramePtr SceneMotion::at(double seconds, const std::atomic<bool>* isCancelled,
                                     const Progress& notify)
{
    model::CrowdFrame frame{m_scene.population, m_templates, seconds};
    frame.hiddenGroups = model::groupsThat(m_scene.groups, &model::Group::isHidden);
    if (m_take) {
        const auto [before, after] = m_take->around(seconds);
        if (before) {
            applyPose(*before, *after, frame);
        } else {
            m_takeProblem = model::Message(
                QT_TRANSLATE_NOOP("Messages", "The take \"%1\" cannot be read at %2 s: its file is "
                                              "damaged. Fetch it from a copy."),
                model::shownTake(m_scene.takes)->name, seconds);
        }
    } else if (m_run) {
        const auto [before, after] = around(seconds, isCancelled, notify);
        if (!before) {
            return nullptr;
        }
        applyPose(*before, *after, frame);
    }
    return std::make_shared<const model::CrowdFrame>(std::move(frame));
}

std::vector<std::string> SceneMotion::problems() const
{
    std::vector<std::string> problems;
    if (m_run) {
        for (const Problem& problem : m_run->session().problems()) {
            problems.push_back(problem.text.english());
        }
    }
    for (const model::Message* problem : {&m_surfaceProblem, &m_takeProblem}) {
        if (!problem->empty()) {
            problems.push_back(problem->english());
        }
    }
    return problems;
}

} // namespace crowd::behavior
