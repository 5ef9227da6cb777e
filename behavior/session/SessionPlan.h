// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "behavior/crowd/WallField.h"
#include "model/population/Columns.h"
#include "model/scene/Path.h"
#include "model/scene/Scene.h"

namespace crowd::behavior {

/// What a session needs to know beside the scene. Metres, metres per second.
struct SessionPlan
{
    struct Walker
    {
        model::IndividualId id = 0;
        model::PathId path = 0;
        float metresPerSecond = model::kUsualWalkingSpeed;
    };
    std::vector<model::Place> places;
    std::vector<model::Path> paths;
    std::vector<Walker> walkers; ///< empty: who walks along which path is in the population
    std::vector<Wall> walls;     ///< beside those of the surface

    /// What the scene itself says.
    [[nodiscard]] static SessionPlan of(const model::Scene& scene)
    {
        SessionPlan plan;
        plan.places = scene.places;
        plan.paths = scene.paths;
        return plan;
    }
};

} // namespace crowd::behavior
