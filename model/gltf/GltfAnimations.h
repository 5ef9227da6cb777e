// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "model/gltf/GltfFile.h"
#include "model/gltf/GltfNodes.h"
#include "model/template/Template.h"

namespace crowd::model::gltf {

/// Animations become clips of `asset`, whose nodes are `scene`'s; a file without any gets the
/// resting pose. Names are made unique, extras speed, loop and seatHeight are read.
Result<void> buildClips(const GltfFile& file, const SceneNodes& scene, Template& asset);

} // namespace crowd::model::gltf
