// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include "model/bake/Pose.h"
#include "model/template/Template.h"

namespace crowd::model::gltf {

/// How a clip that is known to be a gait gets on.
struct FootStride
{
    glm::vec3 ground{0.0F}; ///< how the ground passes under the feet, m/s, template frame; or zero
    bool isAloft = false;   ///< the body never touches the ground
};

/// `measured`, how the ground passes by foot contact (zero where that says nothing), as long as it
/// fits how far and how often the feet swing. Else looks at each foot by itself: how it moves while
/// it is low; where that fits neither, how it swings. For gaits whose feet never quite stand still
/// on the ground: runs with much air, feet that roll, loops that lack their last frame.
[[nodiscard]] FootStride footStride(const Template& asset, const Mesh& feet, int clip,
                                    ClipRole role, const glm::vec3& measured, Pose& pose);

} // namespace crowd::model::gltf
