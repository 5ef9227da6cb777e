// SPDX-License-Identifier: MIT
#include "widgets/state/SceneSurface.h"

#include <algorithm>

#include "model/scene/Scene.h"
#include "widgets/state/SceneChanges.h"

namespace crowd::widgets {

namespace {

constexpr int kProgressMs = 150;
constexpr int kWaysMs = 300; ///< a place that is being dragged comes to rest first

/// Whether somebody may go somewhere, so that it matters where one can walk.
bool hasWalks(const model::Scene& scene)
{
    const auto followed = scene.population.column(model::columns::path);
    if (std::ranges::any_of(followed, [](model::PathId path) { return path != 0; })) {
        return true;
    }
    return std::ranges::any_of(scene.rules, [](const model::Rule& rule) {
        return std::ranges::any_of(rule.actions, [](const model::Action& action) {
            const auto* leave = action.as<model::actions::LeaveScene>();
            return action.kind().text.isWalk && (leave == nullptr || leave->place != 0);
        });
    });
}

/// Whether there is a way to be shown.
bool hasLegs(const model::Scene& scene)
{
    return std::ranges::any_of(scene.paths,
                               [](const model::Path& path) { return path.places.size() > 1; });
}

/// Whether it is more than open ground.
bool isGroundOfInterest(const model::Scene& scene)
{
    return std::ranges::any_of(scene.stages,
                               [](const auto& stage) { return stage.asset != nullptr; }) ||
           std::ranges::any_of(scene.places, [](const model::Place& place) {
               return model::changesWays(place.role) || place.role == model::PlaceRole::Obstacle;
           });
}

} // namespace

SceneSurface::SceneSurface(model::SceneDocument& document, QObject* parent)
    : QObject(parent), m_document(document)
{
    m_progress.setInterval(kProgressMs);
    connect(&m_progress, &QTimer::timeout, this, &SceneSurface::changed);
    m_ways.setSingleShot(true);
    m_ways.setInterval(kWaysMs);
    connect(&m_ways, &QTimer::timeout, this, &SceneSurface::followWays);
    connect(&document, &model::SceneDocument::changed, this, &SceneSurface::followScene);
}

void SceneSurface::followScene(const model::SceneChange& change)
{
    visitChange(
        change,
        [this](const model::StagesChanged&) {
            forget();
            m_ways.start();
        },
        [this](const model::SceneReplaced&) {
            forget();
            m_plan = {}; // it holds the stages
            m_ways.start();
        },
        [this](const model::PathsChanged&) { m_ways.start(); });
}

/// It is of other stages.
void SceneSurface::forget()
{
    m_builder.cancel();
    m_current.reset();
    m_isStale = true;
    m_progress.stop();
    Q_EMIT changed();
}

/// Areas or the settings of the surface are others now.
void SceneSurface::followWays()
{
    const model::Scene& scene = m_document.scene();
    const bool isOutdated = !m_isStale && !behavior::SurfacePlan::of(scene).hasSameWays(m_plan);
    m_isStale = m_isStale || isOutdated;
    if (isOutdated || (m_isStale && hasLegs(scene))) {
        (void)isReady();
    }
}

bool SceneSurface::isReady()
{
    const model::Scene& scene = m_document.scene();
    const bool isOfInterest = isGroundOfInterest(scene);
    const bool isNeeded = hasWalks(scene) && isOfInterest;
    if (m_isStale && (isNeeded || (hasLegs(scene) && isOfInterest))) {
        build();
    } else if (m_isStale && m_current && !isOfInterest) {
        m_builder.cancel();
        m_current.reset(); // the last area is gone, and there is no stage
        m_plan = {};
        m_isStale = false;
        Q_EMIT used();
        Q_EMIT changed();
    }
    return !isNeeded || !m_builder.isBuilding();
}

void SceneSurface::build()
{
    m_isStale = false;
    m_problem = {};
    m_plan = behavior::SurfacePlan::of(m_document.scene());
    m_builder.start(m_plan, [this](const model::Result<SurfacePtr>& built) { take(built); });
    m_progress.start();
    Q_EMIT changed();
}

void SceneSurface::take(const model::Result<SurfacePtr>& built)
{
    if (built) {
        m_current = built.value();
    } else {
        m_problem = built.error().said;
    }
    m_progress.stop();
    Q_EMIT used();
    Q_EMIT changed();
    Q_EMIT found();
}

SurfacePtr SceneSurface::known() const
{
    return !m_isStale && !m_builder.isBuilding() ? m_current : nullptr;
}

double SceneSurface::progress() const
{
    return m_builder.isBuilding() ? static_cast<double>(m_builder.progress()) : -1.0;
}

std::size_t SceneSurface::polygons() const
{
    return m_current ? m_current->polygons() : 0;
}

} // namespace crowd::widgets
