// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"

namespace tinygltf {
class Model;
}

namespace crowd::model::gltf {

/// Replaces what EXT_mesh_gpu_instancing says of a node by a child of it for each instance, which
/// draws the node's mesh in its place. Structure and layout of the model are valid, before and
/// after.
Result<void> expandInstances(tinygltf::Model& model);

} // namespace crowd::model::gltf
