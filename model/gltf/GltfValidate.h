// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/base/Result.h"
#include "model/gltf/GltfJson.h"

/// Checks of the raw JSON, before anything is believed: after these every index points at
/// something, every accessor lies within its view, every view within its buffer, and the nodes are
/// trees. Messages begin with the place ("accessors[3].byteOffset …").
namespace crowd::model::gltf {

/// Version, required extensions, shapes of the arrays, and every index of the file. Whole numbers
/// written as 3.0 become 3.
Result<void> validateStructure(Json& root);

/// Offsets and lengths of bufferViews and accessors against the buffers' real sizes in bytes.
Result<void> validateLayout(const Json& root, const std::vector<std::size_t>& bufferBytes);

/// Size of one component and number of components of an accessor; 0 for what is none.
[[nodiscard]] std::size_t componentBytes(std::uint64_t componentType);
[[nodiscard]] std::size_t componentCount(const std::string& type);
/// Bytes of one element, with the padding of matrix columns.
[[nodiscard]] std::size_t elementBytes(std::uint64_t componentType, const std::string& type);

} // namespace crowd::model::gltf
