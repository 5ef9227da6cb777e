// SPDX-License-Identifier: MIT
#include "behavior/surface/GroundKeeper.h"

#include "behavior/surface/WalkSurface.h"

namespace crowd::behavior {

model::WalkableGroundPtr GroundKeeper::of(const model::Scene& scene)
{
    const SurfacePlan plan = SurfacePlan::ofStages(scene);
    const std::scoped_lock lock(m_mutex);
    if (m_isFound && plan.hasSameStages(m_plan) && plan.hasSameWays(m_plan)) {
        return m_ground;
    }
    m_plan = plan;
    m_isFound = true;
    m_ground.reset();
    if (plan.isWorthwhile()) {
        WalkSurface::Progress progress;
        if (auto built = WalkSurface::build(plan, progress)) {
            m_ground = built.value();
        }
    }
    return m_ground;
}

} // namespace crowd::behavior
