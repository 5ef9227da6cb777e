// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "behavior/surface/SurfacePlan.h"
#include "behavior/surface/WalkSurface.h"

namespace crowd::widgets {

using SurfacePtr = std::shared_ptr<const behavior::WalkSurface>;

/// Finds walkable surfaces in the background, one at a time. What is cancelled ends by itself soon,
/// and its owner does not wait for it; only the destructor does. To be used by one thread.
class SurfaceBuilder
{
public:
    SurfaceBuilder();
    ~SurfaceBuilder();
    SurfaceBuilder(const SurfaceBuilder&) = delete;
    SurfaceBuilder& operator=(const SurfaceBuilder&) = delete;

    /// Cancels the one before. `done` is called on the thread that finds it, when `take` has it.
    void start(behavior::SurfacePlan plan, std::function<void()> done = {});
    void cancel();
    [[nodiscard]] bool isBuilding() const { return m_job != nullptr; } ///< until it is taken
    [[nodiscard]] float progress() const; ///< 0..1, of what is building
    void wait();
    /// Nothing: it is not found yet, or nothing is being found.
    [[nodiscard]] std::optional<model::Result<SurfacePtr>> take();

private:
    struct Job;

    std::unique_ptr<Job> m_job;
    std::vector<std::unique_ptr<Job>> m_cancelled;
};

} // namespace crowd::widgets
