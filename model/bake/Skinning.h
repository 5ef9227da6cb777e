// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "model/template/Template.h"

namespace crowd::model {

/// Linear-blend skinning of one level: positions (V long) and unit normals (V long, or empty if not
/// wanted) in the frame of `bones`, which are Pose::bones of the same template. Normals go by the
/// cofactors of the blended matrix with the sign of its determinant, which is the inverse transpose
/// up to a positive factor, so scaled and mirrored bones come out right and flattened ones finite.
/// Allocates nothing. Thread-safe.
void skin(const Mesh& mesh, std::span<const glm::mat4> bones, std::span<glm::vec3> positions,
          std::span<glm::vec3> normals);

} // namespace crowd::model
