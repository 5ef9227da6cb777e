// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <glm/vec3.hpp>

#include "model/template/Template.h"

namespace crowd::model {

/// The mean colour of a slot of a template in one of its materials, linear, without light and
/// without tint: the material's factor, its picture and the colours of vertices, over the surface
/// of the finest level in the bind pose. `slot` and `choice` are indices of the template.
[[nodiscard]] glm::vec3 slotColour(const Template& asset, std::size_t slot, std::size_t choice);

} // namespace crowd::model
