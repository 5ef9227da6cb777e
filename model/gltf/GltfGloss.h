// SPDX-License-Identifier: MIT
#pragma once

namespace tinygltf {
struct Material;
} // namespace tinygltf

namespace crowd::model::gltf {

class ImageTable;

/// How a surface mirrors, all over: where the file has pictures of it, their mean. Both 0..1.
struct Gloss
{
    float roughness = 1.0F; ///< 0 a mirror, 1 without highlights
    float metallic = 0.0F;
};

/// From either workflow. What is unlit, or says it by a picture that cannot be read, mirrors
/// nothing.
[[nodiscard]] Gloss glossOf(const tinygltf::Material& material, ImageTable& images);

} // namespace crowd::model::gltf
