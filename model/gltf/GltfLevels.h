// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/base/Message.h"
#include "model/gltf/GltfNodes.h"

namespace crowd::model::gltf {

/// A node that draws a mesh.
struct MeshUse
{
    int node = 0;   ///< index into SceneNodes::nodes
    int object = 0; ///< the same for all levels of one thing
    std::string name;
};

/// What to draw at each level of detail, 0 the finest; in node order. Levels come from MSFT_lod and
/// from names that end in _LODn; what has fewer levels than the rest keeps its last one. At most
/// kMaxLevels; further ones are dropped with a warning. Never empty.
[[nodiscard]] std::vector<std::vector<MeshUse>>
planLevels(const tinygltf::Model& model, const SceneNodes& scene, std::vector<Message>& warnings);

} // namespace crowd::model::gltf
