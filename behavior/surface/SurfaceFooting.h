// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "behavior/surface/Footing.h"
#include "model/pick/WalkableGround.h"

namespace crowd::behavior {

struct SurfaceData;

/// A point of the ground, as the mesh has it.
struct GroundPoint
{
    std::uint32_t polygon = 0; ///< a reference of Detour's
    glm::vec3 point{0.0F};
};

/// Where on a surface people stand, and what is under their feet: what WalkSurface says of the
/// functions of the same names. Refers to the surface's data; any thread.
class SurfaceFooting
{
public:
    explicit SurfaceFooting(const SurfaceData& data) : m_data(data) {}

    [[nodiscard]] float underfoot(float x, float z, float surfaceHeight) const;
    [[nodiscard]] float height(float x, float z, float near) const;
    bool follow(Footing& footing, const glm::vec3& feet) const;
    [[nodiscard]] bool isWalkable(const glm::vec3& point) const;
    [[nodiscard]] std::optional<glm::vec3> nearest(const glm::vec3& point) const;
    /// The nearest of the ground, as seen from above, that ways lead over: within reach.x metres,
    /// and reach.y up or down.
    [[nodiscard]] std::optional<GroundPoint> groundBeside(const glm::vec3& point,
                                                          const glm::vec3& reach) const;
    [[nodiscard]] model::WalkRefusal refusal(const glm::vec3& point) const;

private:
    const SurfaceData& m_data;
};

} // namespace crowd::behavior
