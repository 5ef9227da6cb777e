// SPDX-License-Identifier: MIT
#pragma once

#include "model/gltf/GltfCheck.h"

namespace crowd::model::gltf {

/// Images, textures, materials and meshes.
/// False: see JsonCheck::problem().
bool checkMeshes(JsonCheck& check);

} // namespace crowd::model::gltf
