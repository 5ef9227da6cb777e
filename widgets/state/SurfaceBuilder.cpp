// SPDX-License-Identifier: MIT
#include "widgets/state/SurfaceBuilder.h"

#include <stop_token>
#include <utility>

namespace crowd::widgets {

void SurfaceBuilder::start(behavior::SurfacePlan plan, Found found)
{
    cancel();
    m_progress = std::make_shared<Progress>();
    m_task.start(
        [plan = std::move(plan), progress = m_progress](const TaskReport& report) {
            const std::stop_callback stops(report.stop(),
                                           [&progress] { progress->isCancelled = true; });
            return behavior::WalkSurface::build(plan, *progress);
        },
        std::move(found));
}

float SurfaceBuilder::progress() const
{
    return isBuilding() ? m_progress->done.load() : 0.0F;
}

} // namespace crowd::widgets
