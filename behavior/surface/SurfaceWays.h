// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "behavior/surface/Footing.h"

namespace crowd::behavior {

struct SurfaceData;

/// Ways over a surface, spread over the width of a flow: what WalkSurface says of the functions of
/// the same names. Refers to the surface's data; any thread.
class SurfaceWays
{
public:
    explicit SurfaceWays(const SurfaceData& data) : m_data(data) {}

    [[nodiscard]] std::vector<glm::vec3> way(const glm::vec3& from, const glm::vec3& to,
                                             const Lane& lane) const;
    [[nodiscard]] std::optional<float> wayMetres(const glm::vec3& from, const glm::vec3& to,
                                                 float within) const;
    [[nodiscard]] std::optional<bool> isStraight(const glm::vec3& from, const glm::vec3& to) const;
    [[nodiscard]] std::optional<glm::vec3> straight(const glm::vec3& from,
                                                    const glm::vec3& to) const;

private:
    const SurfaceData& m_data;
};

} // namespace crowd::behavior
