// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "model/scene/Scene.h"

namespace crowd::behavior {

using model::SurfaceSettings;

/// All that a surface is made from.
struct SurfacePlan
{
    std::vector<model::StageEntry> stages;
    std::vector<glm::vec3> points; ///< also reached, where they are beside the stages
    SurfaceSettings settings;
    std::vector<model::Place> areas; ///< those that change ways, and obstacles

    [[nodiscard]] static SurfacePlan of(const model::Scene& scene);
    /// What there is to walk on whoever and whatever is there: the same for the same stages.
    [[nodiscard]] static SurfacePlan ofStages(const model::Scene& scene);
    /// Whether it is anything but open ground.
    [[nodiscard]] bool isWorthwhile() const;
    /// Whether ways lead the same where the stages are the same.
    [[nodiscard]] bool hasSameWays(const SurfacePlan& other) const;
    /// Whether they are the same files, where they stand.
    [[nodiscard]] bool hasSameStages(const SurfacePlan& other) const;
};

} // namespace crowd::behavior
