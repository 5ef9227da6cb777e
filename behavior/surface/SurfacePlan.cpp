// SPDX-License-Identifier: MIT
#include "behavior/surface/SurfacePlan.h"

#include <algorithm>
#include <cmath>

#include "model/base/Bounds.h"
#include "model/scene/PlaceShape.h"

namespace crowd::behavior {

SurfacePlan SurfacePlan::of(const model::Scene& scene)
{
    SurfacePlan plan{scene.stages, {}, scene.surface, {}};
    const auto positions = scene.population.column(model::columns::position);
    plan.points.assign(positions.begin(), positions.end());
    for (const model::Place& place : scene.places) {
        plan.points.push_back(place.position);
        for (const glm::vec3& corner : model::cornersOf(place)) {
            plan.points.push_back(corner);
        }
        const bool isArea =
            model::changesWays(place.role) || place.role == model::PlaceRole::Obstacle;
        if (isArea && model::Bounds::isPlace(place.position) && std::isfinite(place.radius)) {
            plan.areas.push_back(place);
        }
    }
    return plan;
}

SurfacePlan SurfacePlan::ofStages(const model::Scene& scene)
{
    return {scene.stages, {}, scene.surface, {}};
}

bool SurfacePlan::isWorthwhile() const
{
    return !areas.empty() ||
           std::ranges::any_of(stages, [](const auto& stage) { return stage.asset != nullptr; });
}

bool SurfacePlan::hasSameWays(const SurfacePlan& other) const
{
    return settings == other.settings &&
           std::ranges::equal(areas, other.areas, [](const auto& a, const auto& b) {
               return a.role == b.role && a.position == b.position && a.radius == b.radius &&
                      a.speedShare == b.speedShare && a.shape == b.shape && a.corners == b.corners;
           });
}

bool SurfacePlan::hasSameStages(const SurfacePlan& other) const
{
    return std::ranges::equal(stages, other.stages, [](const auto& a, const auto& b) {
        return a.asset == b.asset && a.position == b.position &&
               a.headingRadians == b.headingRadians && a.scale == b.scale;
    });
}

} // namespace crowd::behavior
