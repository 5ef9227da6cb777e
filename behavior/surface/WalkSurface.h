// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "behavior/crowd/WallField.h"
#include "behavior/surface/Footing.h"
#include "behavior/surface/SurfacePlan.h"
#include "model/base/Result.h"
#include "model/pick/WalkableGround.h"

namespace crowd::behavior {

struct SurfaceData;

/// What can be walked on: made by Recast from the stages and the ground (the plane y = 0), asked
/// through Detour. Immutable once built; all queries are thread-safe. World frame, metres.
class WalkSurface : public model::WalkableGround
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
    build(const SurfacePlan& given, Progress& progress);
    ~WalkSurface() override;
    WalkSurface(const WalkSurface&) = delete;
    WalkSurface& operator=(const WalkSurface&) = delete;

    /// Corners of a way from one point to another, the last one `to` or the nearest point to it
    /// that can be reached. Empty: `from` is nowhere on the surface.
    [[nodiscard]] std::vector<glm::vec2> way(const glm::vec3& from, const glm::vec3& to) const;
    /// The same with heights, for one of many who share the way: where it bends he keeps as far
    /// from what it leads around as his lane says.
    [[nodiscard]] std::vector<glm::vec3> way(const glm::vec3& from, const glm::vec3& to,
                                             const Lane& lane) const;
    [[nodiscard]] std::optional<float> wayMetres(const glm::vec3& from, const glm::vec3& to,
                                                 float within) const override;
    /// Whether one gets from a point to another one, on its level, straight on. Nothing where the
    /// first is not on the surface.
    [[nodiscard]] std::optional<bool> isStraight(const glm::vec3& from, const glm::vec3& to) const;
    /// `to`, or how far one gets towards it straight on from `from`, on the surface. Nothing
    /// where `from` is not on it.
    [[nodiscard]] std::optional<glm::vec3> straight(const glm::vec3& from,
                                                    const glm::vec3& to) const;
    /// Height of what is underfoot at (x, z), on the level nearest to `near`; `near` where there
    /// is none.
    [[nodiscard]] float height(float x, float z, float near) const;
    /// Somebody who walks has come to a point: his footing follows over what is linked only, so
    /// that nobody gets to another level without a way there. Who had none, or jumped, is found
    /// anew. False: nowhere near the surface.
    bool follow(Footing& footing, const glm::vec3& feet) const;
    /// Height of what is underfoot at (x, z), within a step of the surface's height there.
    [[nodiscard]] float underfoot(float x, float z, float surfaceHeight) const;
    /// So far from his footing somebody stands at most.
    [[nodiscard]] float margin() const;
    /// Whether there is something to walk on within so many metres of a point.
    [[nodiscard]] bool reaches(const glm::vec3& point, float metres) const;
    /// Borders of the surface but for the open ground's, which nobody crosses.
    [[nodiscard]] std::span<const Wall> walls() const;
    [[nodiscard]] std::size_t polygons() const;

    [[nodiscard]] bool isWalkable(const glm::vec3& point) const override;
    [[nodiscard]] std::optional<glm::vec3> nearest(const glm::vec3& point) const override;
    [[nodiscard]] model::WalkRefusal refusal(const glm::vec3& point) const override;
    [[nodiscard]] std::vector<std::array<glm::vec3, 3>> triangles() const override;

private:
    explicit WalkSurface(std::unique_ptr<SurfaceData> data);
    std::unique_ptr<SurfaceData> m_data;
};

} // namespace crowd::behavior
