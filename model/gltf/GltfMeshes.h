// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "model/base/Result.h"
#include "model/gltf/GltfFile.h"
#include "model/gltf/GltfNodes.h"
#include "model/template/Template.h"

namespace crowd::model::gltf {

/// Fills levels, bones, slots, parts and images of `asset`, whose nodes are `scene`'s.
/// `report(fraction)` returns false to cancel.
Result<void> buildMeshes(GltfFile& file, const SceneNodes& scene, Template& asset,
                         const std::function<bool(float)>& report);

/// What an import that was cancelled fails with.
inline constexpr const char* kCancelled = "the import was cancelled";

} // namespace crowd::model::gltf
