// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/base/Result.h"
#include "model/gltf/GltfContainer.h"
#include "model/gltf/GltfJson.h"

namespace crowd::model::gltf {

/// Whether a buffer only stands in for readers that know no EXT_meshopt_compression, and so may
/// have no data.
[[nodiscard]] bool isFallback(const Json& buffer);

/// Decodes the views that EXT_meshopt_compression (or its KHR successor) compresses: each gets a
/// buffer of its own, appended to `buffers`, and becomes a plain view. The structure is valid.
Result<void> decodeMeshopt(Json& root, std::vector<Bytes>& buffers);

} // namespace crowd::model::gltf
