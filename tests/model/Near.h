// SPDX-License-Identifier: MIT
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace crowd::testing {

/// Both in metres.
inline bool near(const glm::vec3& a, const glm::vec3& b, float tolerance = 1e-5F)
{
    return glm::length(a - b) < tolerance;
}

} // namespace crowd::testing
