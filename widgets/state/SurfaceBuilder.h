// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "behavior/surface/SurfacePlan.h"
#include "behavior/surface/WalkSurface.h"
#include "widgets/tasks/BackgroundTask.h"

namespace crowd::widgets {

using SurfacePtr = std::shared_ptr<const behavior::WalkSurface>;

/// Finds walkable surfaces in the background, one at a time. Main thread.
class SurfaceBuilder
{
public:
    using Found = std::function<void(const model::Result<SurfacePtr>&)>;

    /// Cancels the one before.
    void start(behavior::SurfacePlan plan, Found found);
    void cancel() { m_task.cancel(); }
    [[nodiscard]] bool isBuilding() const { return m_task.isRunning(); } ///< until it is found
    [[nodiscard]] float progress() const; ///< 0..1, of what is building
    void wait() { m_task.wait(); }        ///< until it is found

private:
    using Progress = behavior::WalkSurface::Progress;

    std::shared_ptr<Progress> m_progress; ///< shared with the thread that is building
    BackgroundTask m_task;
};

} // namespace crowd::widgets
