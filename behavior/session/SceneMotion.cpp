// SPDX-License-Identifier: MIT
#include "behavior/session/SceneMotion.h"

#include <utility>

#include "behavior/surface/WalkSurface.h"
#include "behavior/takes/EditedTake.h"

namespace crowd::behavior {

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
    m_session = std::make_unique<Session>(m_scene);
    if (m_surface) {
        m_session->setSurface(m_surface);
    }
    m_after = m_session->pose();
    m_before = m_after;
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
    } else if (m_session) {
        if (seconds < m_before->seconds) {
            begin();
        }
        while (m_after->seconds < seconds - 1e-9) {
            if (isCancelled != nullptr && *isCancelled) {
                return nullptr;
            }
            m_session->step();
            m_before = std::exchange(m_after, m_session->pose());
            if (notify) {
                notify(m_after->seconds);
            }
        }
        applyPose(*m_before, *m_after, frame);
    }
    return std::make_shared<const model::CrowdFrame>(std::move(frame));
}

std::vector<std::string> SceneMotion::problems() const
{
    std::vector<std::string> problems;
    if (m_session) {
        for (const Problem& problem : m_session->problems()) {
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
