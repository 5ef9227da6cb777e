// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "behavior/crowd/WallField.h"
#include "behavior/surface/SurfacePlan.h"
#include "model/base/Result.h"

namespace crowd::behavior {

/// What can be walked on: made by Recast from the stages and the ground (the plane y = 0), asked
/// through Detour. Immutable once built; all queries are thread-safe. World frame, metres.
class WalkSurface
{
public:
    struct Progress
    {
        std::atomic<float> done{0.0F}; ///< 0..1
        std::atomic<bool> isCancelled{false};
        const std::atomic<bool>* isCancelledToo = nullptr; ///< of whoever waits for more than this

        [[nodiscard]] bool isOver() const
        {
            return isCancelled || (isCancelledToo != nullptr && *isCancelledToo);
        }
    };

    /// Takes some seconds for a city; made to be called on a thread of its own.
    [[nodiscard]] static model::Result<std::shared_ptr<const WalkSurface>>
    build(const SurfacePlan& plan, Progress& progress);
    ~WalkSurface();
    WalkSurface(const WalkSurface&) = delete;
    WalkSurface& operator=(const WalkSurface&) = delete;

    /// Corners of a way from one point to another, the last one `to` or the nearest point to it
    /// that can be reached. Empty: `from` is nowhere on the surface.
    [[nodiscard]] std::vector<glm::vec2> way(const glm::vec3& from, const glm::vec3& to) const;
    /// `to`, or how far one gets towards it straight on from `from`, on the surface. Nothing
    /// where `from` is not on it.
    [[nodiscard]] std::optional<glm::vec3> straight(const glm::vec3& from,
                                                    const glm::vec3& to) const;
    /// Height of the surface at (x, z), nearest to `near`; `near` where there is none.
    [[nodiscard]] float height(float x, float z, float near) const;
    /// Whether there is something to walk on within so many metres of a point.
    [[nodiscard]] bool reaches(const glm::vec3& point, float metres) const;
    /// Borders of the surface but for the open ground's, which nobody crosses.
    [[nodiscard]] std::span<const Wall> walls() const;
    [[nodiscard]] std::size_t polygons() const;

private:
    struct Private;
    explicit WalkSurface(std::unique_ptr<Private> data);
    std::unique_ptr<Private> m_private;
};

} // namespace crowd::behavior
