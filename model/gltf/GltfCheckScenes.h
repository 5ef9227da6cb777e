// SPDX-License-Identifier: MIT
#pragma once

#include "model/gltf/GltfCheck.h"

namespace crowd::model::gltf {

/// Nodes, skins, animations and scenes.
/// False: see JsonCheck::problem().
bool checkScenes(JsonCheck& check);

} // namespace crowd::model::gltf
