// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/base/Result.h"
#include "model/gltf/GltfContainer.h"
#include "model/gltf/GltfJson.h"

namespace crowd::model::gltf {

/// Decodes the primitives that KHR_draco_mesh_compression compresses: their indices and attributes
/// get accessors, views and buffers of their own, appended to the file, and the extension goes.
/// Primitives that also have plain data are left to that. Structure and layout are valid, before
/// and after. libdraco runs in a process of its own, since damaged data makes it crash.
Result<void> decodeDraco(Json& root, std::vector<Bytes>& buffers);

} // namespace crowd::model::gltf
