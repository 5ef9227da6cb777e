// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "behavior/surface/Footing.h"

namespace crowd::behavior {

struct SurfaceData;

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

private:
    const SurfaceData& m_data;
};

} // namespace crowd::behavior
