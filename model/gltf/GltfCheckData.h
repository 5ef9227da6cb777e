// SPDX-License-Identifier: MIT
#pragma once

#include "model/gltf/GltfCheck.h"

namespace crowd::model::gltf {

/// Buffers, views and accessors by themselves; their extents are for validateLayout.
/// False: see JsonCheck::problem().
bool checkData(JsonCheck& check);

} // namespace crowd::model::gltf
