// SPDX-License-Identifier: MIT
#pragma once

#include "model/gltf/GltfNodes.h"
#include "model/scene/Stage.h"
#include "model/template/Template.h"

namespace tinygltf {
class Model;
}

namespace crowd::model::gltf {

/// Level 0 of an imported file at rest as a stage, with the seats that its extras name.
[[nodiscard]] StagePtr flattenStage(const tinygltf::Model& model, const SceneNodes& scene,
                                    Template asset);

} // namespace crowd::model::gltf
