// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/gltf/GltfJson.h"

namespace crowd::model::gltf {

/// KHR_animation_pointer: channels that point to a node's translation, rotation, scale or weights
/// become channels of that node. Others, which move nothing that is drawn, are taken out with a
/// warning; so are animations that have none left. The structure of `root` has been checked.
void resolveAnimationPointers(Json& root, std::vector<Message>& warnings);

} // namespace crowd::model::gltf
