// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "model/scene/Scene.h"
#include "model/view/View.h"

namespace crowd::model {

/// Where a ray meets the stage or the ground. World frame, metres.
struct SurfaceHit
{
    glm::vec3 point{0.0F};
    glm::vec3 normal{0.0F, 1.0F, 0.0F}; ///< unit, of the triangle, on the side of the ray
    float distance = 0.0F;              ///< along the ray
    bool isGround = false;              ///< the plane y = 0, not a stage
};

/// Ray queries against the stages of a scene (Embree, pinned to one instruction set so that the
/// same machine type gives the same bits) and against the ground plane y = 0 seen from above.
/// Queries are thread-safe; setStages is not.
class StageRays
{
public:
    StageRays();
    ~StageRays();
    StageRays(const StageRays&) = delete;
    StageRays& operator=(const StageRays&) = delete;

    /// Takes over the loaded stages where they stand; does nothing when nothing changed.
    void setStages(std::span<const StageEntry> stages);
    /// Grows with each change of the geometry.
    [[nodiscard]] std::uint64_t version() const;

    /// Of all stages where they stand; empty without any.
    [[nodiscard]] const Bounds& bounds() const;

    /// The nearest of stage and ground, from whichever side: who walks asks what is above him from
    /// within a wall too.
    [[nodiscard]] std::optional<SurfaceHit>
    hit(const Ray& ray, float maxDistance = std::numeric_limits<float>::infinity()) const;
    /// Whether the stage (not the ground) stands between two points; grazing the end is not,
    /// nor is what is looked through from behind.
    [[nodiscard]] bool isBlocked(const glm::vec3& from, const glm::vec3& to) const;
    /// All surfaces that a vertical line meets, from the top, the ground last; at most 8.
    [[nodiscard]] std::vector<SurfaceHit> below(const glm::vec3& from) const;

    /// Height of the surface nearest above or below a point, so that a floor further up or down is
    /// not taken; the point's own where there is none.
    [[nodiscard]] float heightNear(const glm::vec3& at) const;

private:
    struct Private;
    std::unique_ptr<Private> m_private;
};

} // namespace crowd::model
