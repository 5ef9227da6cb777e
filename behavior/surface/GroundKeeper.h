// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>

#include "behavior/surface/SurfacePlan.h"
#include "model/pick/WalkableGround.h"

namespace crowd::behavior {

/// Where people can walk on the stages of a scene, whoever and whatever stands there: found when it
/// is first asked for, which takes seconds for a city, and kept as long as the stages stay as they
/// are. Any thread.
class GroundKeeper
{
public:
    /// Null: nothing but open ground, or a stage that nobody can walk on at all.
    [[nodiscard]] model::WalkableGroundPtr of(const model::Scene& scene);

private:
    std::mutex m_mutex;
    SurfacePlan m_plan;
    bool m_isFound = false;
    model::WalkableGroundPtr m_ground;
};

} // namespace crowd::behavior
