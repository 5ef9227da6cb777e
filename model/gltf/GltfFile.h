// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/base/Result.h"

namespace tinygltf {
class Model;
}

namespace crowd::model::gltf {

/// A glTF file read and checked: every index in `model` is valid, every accessor lies within its
/// buffer, nodes are trees, buffers are in memory. Images hold their encoded bytes in `image`.
struct GltfFile
{
    GltfFile();
    ~GltfFile();
    GltfFile(GltfFile&&) noexcept;
    GltfFile& operator=(GltfFile&&) noexcept;

    std::string name; ///< file name without folder and suffix
    std::unique_ptr<tinygltf::Model> model;
    /// One an image: why its bytes could not be had; empty when they could.
    std::vector<std::string> imageProblems;
    std::vector<std::string> warnings;
};

/// Messages name the file, the place and the way out.
Result<GltfFile> readGltf(const std::string& path);

/// "FILE: what. WAY OUT" with the usual way out unless `problem` already tells one.
[[nodiscard]] Error fileError(const std::string& path, const std::string& problem);

} // namespace crowd::model::gltf
