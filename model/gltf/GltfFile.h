// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "model/base/Result.h"

namespace tinygltf {
class Model;
}

namespace crowd::model::gltf {

/// Where the encoded bytes of a picture are: in the buffer, or behind the URI, or nowhere.
struct ImageSource
{
    std::string name;
    std::string uri;
    int buffer = -1;
    std::size_t offset = 0; ///< within the buffer, with `length`
    std::size_t length = 0;
};

/// A glTF file read and checked: every index in `model` is valid, every accessor lies within its
/// buffer, nodes are trees, buffers are in memory. The model's images are in `images` instead.
struct GltfFile
{
    GltfFile();
    ~GltfFile();
    GltfFile(GltfFile&&) noexcept;
    GltfFile& operator=(GltfFile&&) noexcept;

    std::string name; ///< file name without folder and suffix
    std::unique_ptr<tinygltf::Model> model;
    std::string folder; ///< of the file, for URIs
    std::vector<ImageSource> images;
    std::vector<Message> warnings;
    bool wantsReliefs = false; ///< normal maps are read too
};

/// Messages name the file, the place and the way out.
Result<GltfFile> readGltf(const std::string& path);

/// "FILE: what. WAY OUT" with the usual way out unless `problem` already tells one.
[[nodiscard]] Error fileError(const std::string& path, const Message& problem);

} // namespace crowd::model::gltf
